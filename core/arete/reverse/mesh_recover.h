// SPDX-License-Identifier: MIT
#pragma once

#include "arete/reverse/mesh_reverse.h"

namespace arete {

/// A coarse mesh whose subdivision has the connectivity of a given fine one.
struct RecoveredMesh {
  MeshFaces coarse;
  /// Fine vertex i of mesh_step(coarse) is vertex place[i] of the given mesh.
  std::vector<Index> place;
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
/// Empty when the mesh has no such structure. \throws InvalidField see MeshNeighbours; for a mesh
/// of several connected parts (see connected_faces), and for an open one with Doo-Sabin.
[[nodiscard]] std::vector<RecoveredMesh> recover_coarse(const MeshFaces& fine, MeshScheme scheme);

/// A mesh taken apart.
template <class R>
struct MeshDecomposition {
  MeshScheme scheme = MeshScheme::catmull_clark;
  RecoveredMesh mesh;
  Grid<R> coarse;      ///< positions (or any attributes) of the coarse vertices, one a row
  Grid<R> details;     ///< what subdivision of them misses, at every given vertex
  bool unique = true;  ///< see MeshCoarse
};

/// Finds the coarse mesh and its positions; among several possible ones that with the smallest
/// details. Details are kept for every fine vertex (a mesh has more numbers apart than together);
/// they are 0 to rounding when the mesh was subdivided.
/// \throws InvalidField as recover_coarse, and when the mesh has no subdivision structure.
template <class R>
[[nodiscard]] MeshDecomposition<R> decompose_mesh(const MeshFaces& fine,
                                                  GridView<const R> positions, MeshScheme scheme,
                                                  ReverseMode mode);

/// The positions of the given mesh again, in its own order of vertices.
template <class R>
[[nodiscard]] Grid<R> reconstruct_mesh(const MeshDecomposition<R>& parts);

extern template MeshDecomposition<double> decompose_mesh(const MeshFaces&, GridView<const double>,
                                                         MeshScheme, ReverseMode);
extern template MeshDecomposition<Rational> decompose_mesh(const MeshFaces&,
                                                           GridView<const Rational>, MeshScheme,
                                                           ReverseMode);
extern template Grid<double> reconstruct_mesh(const MeshDecomposition<double>&);
extern template Grid<Rational> reconstruct_mesh(const MeshDecomposition<Rational>&);

}  // namespace arete
