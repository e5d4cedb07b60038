// SPDX-License-Identifier: MIT
#pragma once

#include <OpenMesh/Core/System/omstream.hh>
#include <cmath>
#include <exception>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arete/openmesh/internal/coarse_connectivity.h"
#include "arete/openmesh/internal/components.h"
#include "arete/openmesh/internal/gather.h"
#include "arete/reverse/grid_mesh.h"

namespace arete::openmesh {

/// Catmull-Clark, Loop or Doo-Sabin subdivision undone, attributes and all:
///
///     arete::openmesh::ReverseSubdividerT<MyMesh> reverse(arete::MeshScheme::loop);
///     if (!reverse(mesh, 2)) ...            // two levels coarser, or the reason on omerr()
///     if (!reverse.restore(mesh)) ...       // and back, bit for bit
///
/// What it takes: meshes with the connectivity of a subdivided one (see recover_coarse), closed or
/// open, of several parts, whoever made them: OpenMesh's CatmullClarkT and LoopT, CGAL, OpenSubdiv.
/// Which rule made their boundary is found by trying (see MeshRim). Positions need not be those of
/// a subdivided mesh: what subdivision misses is kept as details. Anything else is refused: false,
/// the first obstacle by number, and the mesh as it was.
///
/// What comes out: the control mesh. Vertices are numbered in the order of their vertex points,
/// part by part. Attributes are handed over, not filtered: a vertex takes those of its vertex
/// point, a face those of a face inside it, an edge and a corner likewise. Normals are recomputed.
///
/// restore() puts levels back. If the coarse vertices were not moved, every bit of the mesh is as
/// it was, handles and all attributes too; if they were moved (multiresolution editing) the details
/// are laid over them. Coarse connectivity must not be changed in between. What was attached to the
/// coarse mesh meanwhile is lost.
///
/// Cost: local O(n log n); least squares see reverse_mesh_step. Memory: a copy of each fine mesh,
/// and its details.
///
/// Mesh: PolyMesh_ArrayKernelT or TriMesh_ArrayKernelT with any traits whose Point has 3
/// components.
template <class Mesh>
class ReverseSubdividerT {
 public:
  using Point = typename Mesh::Point;
  using Real = typename detail::Components<Point>::Scalar;

  explicit ReverseSubdividerT(MeshScheme scheme, ReverseMode mode = ReverseMode::least_squares,
                              std::optional<MeshRim> rim = {})
      : scheme_(scheme), mode_(mode), rim_(rim), name_("arete reverse ") {
    name_ += to_string(scheme);
  }
  /// For meshes that are one regular grid of quads, any scheme of the catalogue: the way back from
  /// GridSubdividerT (see decompose_grid_mesh).
  explicit ReverseSubdividerT(const Scheme& scheme, ReverseMode mode = ReverseMode::least_squares,
                              Boundaries boundaries = {})
      : grid_({scheme, boundaries}), mode_(mode), name_("arete reverse " + scheme.text()) {}

  [[nodiscard]] const char* name() const { return name_.c_str(); }

  /// Undoes `levels` steps; those undone before stay restorable.
  bool operator()(Mesh& mesh, std::size_t levels) {
    return guarded([&] { coarsen_or_throw(mesh, levels); });
  }
  /// Puts the coarsest `levels` steps back, without a number all of them.
  bool restore(Mesh& mesh, std::optional<std::size_t> levels = {}) {
    return guarded([&] { restore_or_throw(mesh, levels); });
  }

  /// The same with the reason as an exception. \throws InvalidField; the mesh is then as it was.
  void coarsen_or_throw(Mesh& mesh, std::size_t levels) {
    const MeshFaces faces = detail::plain_faces(mesh);
    const Grid<double> positions = positions_of(mesh);
    MeshLevels steps =
        taken_apart(faces, positions, static_cast<int>(std::min<std::size_t>(levels, 64)));
    for (auto& step : steps) {
      const detail::CoarseSources sources =
          detail::coarse_sources(mesh, step.mesh, step.rule.scheme);
      undone_.push_back({std::move(step), mesh});
      hand_over(mesh, sources);
      detail::write_connectivity(mesh, undone_.back().step.mesh.coarse);
      set_positions(mesh, undone_.back().step.coarse);
      update_normals(mesh);
    }
  }

  void restore_or_throw(Mesh& mesh, std::optional<std::size_t> levels = {}) {
    const std::size_t steps = levels.value_or(undone_.size());
    if (steps > undone_.size())
      throw InvalidField("there are " + std::to_string(undone_.size()) +
                         " levels to restore, not " + std::to_string(steps));
    if (steps == 0) return;
    const MeshFaces& expected = undone_.back().step.mesh.coarse;
    if (!(detail::plain_faces(mesh) == expected))
      throw InvalidField(
          "the coarse mesh has other faces than when it was made; only move vertices");
    Grid<double> positions = positions_of(mesh);
    // Positions that the mesh's own type has rounded are not moved ones.
    const bool moved = !rounds_to(undone_.back().step.coarse, mesh);
    if (!moved) positions = undone_.back().step.coarse;
    for (std::size_t i = 0; i < steps; ++i) {
      Undone& last = undone_.back();
      positions = reconstruct_mesh<double>(last.step, std::as_const(positions).view());
      mesh = std::move(last.fine);
      undone_.pop_back();
    }
    if (!moved) return;
    set_positions(mesh, positions);
    update_normals(mesh);
  }

  /// What was undone so far, the first step first.
  [[nodiscard]] std::size_t levels() const { return undone_.size(); }
  [[nodiscard]] const MeshDecomposition<double>& level(std::size_t i) const {
    return undone_.at(i).step;
  }
  /// Forgets what was undone, to begin with another mesh.
  void clear() { undone_.clear(); }

 private:
  struct Undone {
    MeshDecomposition<double> step;
    Mesh fine;
  };

  template <class F>
  bool guarded(F&& work) const {
    try {
      work();
      return true;
    } catch (const std::exception& error) {
      ::omerr() << name_ << ": " << error.what() << std::endl;
    }
    return false;
  }

  [[nodiscard]] MeshLevels taken_apart(const MeshFaces& faces, const Grid<double>& positions,
                                       int levels) const {
    if (grid_)
      return decompose_grid_mesh(faces, positions.view(), grid_->first, grid_->second, mode_,
                                 levels);
    const auto rules = undone_.empty() ? candidate_rules(scheme_, rim_)
                                       : std::vector<MeshRule>{undone_.back().step.rule};
    return decompose_mesh_levels(faces, positions.view(), rules, mode_, levels);
  }

  static typename Mesh::VertexHandle handle(Index v) {
    return typename Mesh::VertexHandle(static_cast<int>(v));
  }

  static Grid<double> positions_of(const Mesh& mesh) {
    Grid<double> positions({static_cast<Index>(mesh.n_vertices()), 3});
    for (Index v = 0; v < positions.rows(); ++v)
      for (Index c = 0; c < 3; ++c) {
        positions(v, c) = static_cast<double>(
            detail::Components<Point>::get(mesh.point(handle(v)), static_cast<std::size_t>(c)));
        if (!std::isfinite(positions(v, c)))
          throw InvalidField("vertex " + std::to_string(v) +
                             " has a coordinate that is no finite number; remove it");
      }
    return positions;
  }

  static void set_positions(Mesh& mesh, const Grid<double>& positions) {
    for (Index v = 0; v < positions.rows(); ++v) {
      Point point = mesh.point(handle(v));
      for (Index c = 0; c < 3; ++c)
        detail::Components<Point>::set(point, static_cast<std::size_t>(c),
                                       static_cast<Real>(positions(v, c)));
      mesh.set_point(handle(v), point);
    }
  }

  static bool rounds_to(const Grid<double>& positions, const Mesh& mesh) {
    for (Index v = 0; v < positions.rows(); ++v)
      for (Index c = 0; c < 3; ++c)
        if (static_cast<Real>(positions(v, c)) !=
            detail::Components<Point>::get(mesh.point(handle(v)), static_cast<std::size_t>(c)))
          return false;
    return true;
  }

  static void hand_over(Mesh& mesh, const detail::CoarseSources& sources) {
    const auto gather_all = [](auto begin, auto end, const std::vector<int>& from) {
      for (auto it = begin; it != end; ++it)
        if (*it) detail::gather(**it, from);
    };
    gather_all(mesh.vprops_begin(), mesh.vprops_end(), sources.vertices);
    gather_all(mesh.hprops_begin(), mesh.hprops_end(), sources.halfedges);
    gather_all(mesh.eprops_begin(), mesh.eprops_end(), sources.edges);
    gather_all(mesh.fprops_begin(), mesh.fprops_end(), sources.faces);
  }

  static void update_normals(Mesh& mesh) {
    if (mesh.has_face_normals())
      for (auto f : mesh.faces()) mesh.set_normal(f, mesh.calc_face_normal(f));
    if (!mesh.has_vertex_normals()) return;
    for (auto v : mesh.vertices()) {
      typename Mesh::Normal normal;
      mesh.calc_vertex_normal_correct(v, normal);
      const auto length = ::OpenMesh::norm(normal);
      if (length > 0) normal /= length;
      mesh.set_normal(v, normal);
    }
  }

  MeshScheme scheme_ = MeshScheme::catmull_clark;
  std::optional<std::pair<Scheme, Boundaries>> grid_;
  ReverseMode mode_;
  std::optional<MeshRim> rim_;
  std::string name_;
  std::vector<Undone> undone_;
};

}  // namespace arete::openmesh
