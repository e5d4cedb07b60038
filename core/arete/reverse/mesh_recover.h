// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "arete/reverse/grid_step.h"
#include "arete/reverse/mesh_reverse.h"

namespace arete {

/// A coarse mesh whose subdivision has the connectivity of a given fine one.
struct RecoveredMesh {
  /// Where a face of the given mesh is among those of mesh_step(coarse), and from which corner of
  /// that one it begins.
  struct FacePlace {
    Index face = 0;
    Index turn = 0;
  };

  MeshFaces coarse;
  /// Fine vertex i of mesh_step(coarse) is vertex place[i] of the given mesh.
  std::vector<Index> place;
  std::vector<FacePlace> faces;  ///< one for each face of the given mesh
  /// Set: the step is this one, of a scheme of the catalogue on a grid, and no scheme for meshes
  /// matters.
  std::shared_ptr<const GridStep> grid = {};

  /// The faces of the step, in its own numbers.
  [[nodiscard]] MeshFaces step_faces(MeshScheme scheme) const {
    return grid ? grid->fine_faces() : mesh_step<double>(coarse, scheme).fine;
  }
};

/// All coarse meshes whose subdivision gives exactly these faces (up to the order of faces, where
/// each begins, and the numbering of vertices). A connected mesh has at most four: which vertices
/// were vertex points is a choice for one face, and follows from it everywhere else.
///
/// - Catmull-Clark: quads only; edge points have valence 4 (3 at the boundary) and every edge joins
///   one of them to a vertex or face point.
/// - Loop: triangles only; three quarters of them lie at an old vertex each, one between them.
/// - Doo-Sabin: closed meshes only, every vertex of valence 4: a face's, an edge's, a vertex's and
///   an edge's face follow each other around it.
///
/// Empty when the mesh has no such structure; *reason (if given) then says where it ends.
/// Cost: O(n log n). \throws InvalidField see MeshNeighbours; for a mesh of several connected parts
/// (see connected_faces), and for an open one with Doo-Sabin.
[[nodiscard]] std::vector<RecoveredMesh> recover_coarse(const MeshFaces& fine, MeshScheme scheme,
                                                        std::string* reason = nullptr);

/// The faces of the given mesh, in their own order, from what was recovered.
[[nodiscard]] MeshFaces refined_faces(const RecoveredMesh& mesh, MeshScheme scheme);

/// A mesh taken apart by one step.
template <class R>
struct MeshDecomposition {
  MeshRule rule = MeshScheme::catmull_clark;
  RecoveredMesh mesh;
  Grid<R> coarse;   ///< positions (or any numbers) of the coarse vertices, one a row
  Grid<R> details;  ///< what subdivision of them misses, at every given vertex
  /// What adding the details misses by rounding, almost all zeros: with it every bit comes back.
  Grid<R> remainder;
  bool unique = true;  ///< see MeshCoarse
};

/// The rules that may have made a mesh: the scheme with that rim, or with every rim there is.
[[nodiscard]] std::vector<MeshRule> candidate_rules(MeshScheme scheme,
                                                    std::optional<MeshRim> rim = {});

/// Finds the coarse mesh and its positions; among several possible ones, and several rules, that
/// with the smallest details. Connected parts are taken apart one by one, by the same rule; coarse
/// vertices are numbered part after part. Details are kept for every fine vertex (a mesh has more
/// numbers apart than together); they are 0 to rounding when the mesh was subdivided.
/// \throws InvalidField as recover_coarse but for several parts, and when the mesh has no
/// subdivision structure, saying where. \pre all rules are of one scheme, and there is one
template <class R>
[[nodiscard]] MeshDecomposition<R> decompose_mesh(const MeshFaces& fine,
                                                  GridView<const R> positions,
                                                  const std::vector<MeshRule>& rules,
                                                  ReverseMode mode);
template <class R>
[[nodiscard]] MeshDecomposition<R> decompose_mesh(const MeshFaces& fine,
                                                  GridView<const R> positions, MeshRule rule,
                                                  ReverseMode mode) {
  return decompose_mesh<R>(fine, positions, std::vector<MeshRule>{rule}, mode);
}

/// The positions of the given mesh again, in its own order of vertices: every bit of them in
/// floating point. `coarse` may differ from parts.coarse: the details are then laid over it.
/// \throws InvalidField if the sizes do not fit together.
template <class R>
[[nodiscard]] Grid<R> reconstruct_mesh(const MeshDecomposition<R>& parts, GridView<const R> coarse);
template <class R>
[[nodiscard]] Grid<R> reconstruct_mesh(const MeshDecomposition<R>& parts) {
  return reconstruct_mesh<R>(parts, parts.coarse.view());
}

extern template MeshDecomposition<double> decompose_mesh(const MeshFaces&, GridView<const double>,
                                                         const std::vector<MeshRule>&, ReverseMode);
extern template MeshDecomposition<Rational> decompose_mesh(const MeshFaces&,
                                                           GridView<const Rational>,
                                                           const std::vector<MeshRule>&,
                                                           ReverseMode);
extern template Grid<double> reconstruct_mesh(const MeshDecomposition<double>&,
                                              GridView<const double>);
extern template Grid<Rational> reconstruct_mesh(const MeshDecomposition<Rational>&,
                                                GridView<const Rational>);

}  // namespace arete
