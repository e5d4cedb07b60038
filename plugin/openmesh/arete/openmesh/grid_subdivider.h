// SPDX-License-Identifier: MIT
#pragma once

#include <OpenMesh/Core/System/omstream.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/SubdividerT.hh>
#include <cstdint>
#include <exception>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "arete/openmesh/attribute_rule.h"
#include "arete/openmesh/internal/connectivity.h"
#include "arete/openmesh/internal/corner_attributes.h"
#include "arete/openmesh/internal/edge_attributes.h"
#include "arete/openmesh/internal/face_attributes.h"
#include "arete/openmesh/internal/limit_frame.h"
#include "arete/openmesh/internal/mesh_faces.h"
#include "arete/openmesh/internal/vertex_attributes.h"
#include "arete/openmesh/internal/vertex_normals.h"
#include "arete/scheme/catalogue.h"
#include "arete/topology/orient.h"
#include "arete/topology/recover.h"

namespace arete::openmesh {

/// Any scheme of the catalogue as an OpenMesh subdivider, where CatmullClarkT and its like stand:
///
///     arete::openmesh::GridSubdividerT<MyMesh> subdivide("four-point:omega=1/16");
///     if (!subdivide(mesh, 3)) ...                       // the reason is on omerr()
///
/// What it takes. Meshes of quads that are regular grids - open, tubes or tori, several of them in
/// one mesh - and triangulated open grids, in any order and anywhere in space (see
/// topology/recover.h). x, y and z are refined together. Everything else is refused: false, a
/// message that names the first offending vertex or face, and the mesh is as it was.
///
/// What comes out, after n levels of a scheme of arity m on an open grid of R x C vertices:
/// (m^n (R-1) + 1) x (m^n (C-1) + 1) vertices if the scheme has samples at the old ones, as the
/// primal schemes do. Old vertices keep their handles; new ones follow grid by grid and row by row.
/// Rows run from north to south and columns from west to east as topology/orient.h defines. For
/// schemes without samples at the old ones (Chaikin) every vertex is new, numbered likewise from 0,
/// lone vertices last. Faces and edges are always new, faces row by row; triangles stay triangles,
/// cut as their parents were, and faces keep their sides.
///
/// Open rims follow `boundaries` (default extrapolate: with the cubic B-spline that is
/// Catmull-Clark as OpenSubdiv has it with VTX_BOUNDARY_EDGE_AND_CORNER); closed ones close.
///
/// Attributes. Positions follow the scheme. Vertex texcoords, colours and custom properties follow
/// `rules` (bilinear unless told otherwise). Normals are recomputed: those of the limit surface
/// where the scheme is certified C^1 and has tau = 0, otherwise from central differences. Half-edge
/// texcoords and other half-edge numbers are bilinear within their face, so seams stay; half-edges
/// without a face get zeros. Faces inherit from the old face they lie in, edges from the edge they
/// lie on. A new vertex has those status flags that all old vertices around it have.
/// On closed grids texcoords run back to their start within the last cell, as vertex texcoords
/// must; use half-edge texcoords there.
///
/// update_points = false refines the topology and leaves the shape: new points are bilinear.
///
/// Not touched: mesh properties. Nothing is added to the mesh, not even temporarily. Elements that
/// are deleted but not collected are refused.
///
/// Cost: linear in the result, of which connectivity is most. All levels are computed at once; no
/// level between exists. Memory: the result and a band of rows.
///
/// Mesh: PolyMesh_ArrayKernelT or TriMesh_ArrayKernelT with any traits whose Point has 3
/// components. Real: the arithmetic of positions, float or double.
template <class Mesh, class Real = double>
class GridSubdividerT : public ::OpenMesh::Subdivider::Uniform::SubdividerT<Mesh, Real> {
 public:
  using Base = ::OpenMesh::Subdivider::Uniform::SubdividerT<Mesh, Real>;
  using Point = typename Mesh::Point;
  static_assert(std::is_same_v<Real, float> || std::is_same_v<Real, double>);

  /// Catmull-Clark on a grid.
  GridSubdividerT() : GridSubdividerT(parse_scheme("b-spline:degree=3")) {}
  explicit GridSubdividerT(const Scheme& scheme) { set_scheme(scheme); }
  /// \throws InvalidScheme unless it is the text of a scheme, such as `four-point:omega=1/16`.
  explicit GridSubdividerT(const char* scheme) : GridSubdividerT(parse_scheme(scheme)) {}
  /// The same, attached.
  explicit GridSubdividerT(Mesh& mesh) : GridSubdividerT() { this->attach(mesh); }
  GridSubdividerT(Mesh& mesh, const Scheme& scheme) : GridSubdividerT(scheme) {
    this->attach(mesh);
  }
  ~GridSubdividerT() override { this->detach(); }

  /// The scheme with its parameters.
  const char* name() const override { return name_.c_str(); }

  void set_scheme(const Scheme& scheme) { set_schemes(scheme, scheme); }
  /// One scheme along the rows (from column to column), another along the columns.
  void set_schemes(const Scheme& along_rows, const Scheme& along_cols) {
    along_rows_ = along_rows;
    along_cols_ = along_cols;
    name_ = "arete " + along_rows.text();
    if (along_rows != along_cols) name_ += " x " + along_cols.text();
    stencils_known_ = false;
  }
  /// Whether the new vertices lie on the limit surface instead of on its approximation by the last
  /// level. For schemes with a certified limit; others are refused.
  void set_on_limit(bool on_limit) { on_limit_ = on_limit; }
  /// x: the rims at the ends of the rows, y: those at the ends of the columns.
  void set_boundaries(Boundaries boundaries) { boundaries_ = boundaries; }
  [[nodiscard]] AttributeRules& rules() { return rules_; }
  /// 0: as many as the machine has. The result does not depend on it.
  void set_threads(int threads) { threads_ = threads; }

  /// The same as operator()(mesh, levels), for programs that want the reason as an exception.
  /// \throws NotAGrid, InvalidField; the mesh is then as it was.
  void refine_or_throw(Mesh& mesh, std::size_t levels, bool update_points = true) {
    if (!patches_ || detail::fingerprint(mesh) != fingerprint_) find_grids(mesh);
    if (levels == 0 || patches_->empty()) return;
    refine(mesh, levels, update_points);
    patches_.reset();
  }

 protected:
  bool prepare(Mesh& mesh) override {
    return guarded([&] { find_grids(mesh); });
  }

  bool subdivide(Mesh& mesh, std::size_t levels, const bool update_points = true) override {
    return guarded([&] { refine_or_throw(mesh, levels, update_points); });
  }

  bool cleanup(Mesh&) override {
    patches_.reset();
    return true;
  }

 private:
  using Evaluators = std::vector<detail::PatchEvaluator<Real>>;

  template <class F>
  bool guarded(F&& work) const {
    try {
      work();
      return true;
    } catch (const NotAGrid& error) {
      ::omerr() << name_ << ": " << error.what() << hint() << std::endl;
    } catch (const std::exception& error) {
      ::omerr() << name_ << ": " << error.what() << std::endl;
    }
    return false;
  }

  [[nodiscard]] std::string hint() const {
    const Mask cubic = parse_scheme("b-spline:degree=3").mask();
    if (along_rows_->mask() != cubic || along_cols_->mask() != cubic) return "";
    return "; for general quad meshes this scheme is Catmull-Clark: use OpenSubdiv or CGAL";
  }

  static std::vector<Point3> positions(const Mesh& mesh) {
    std::vector<Point3> points(mesh.n_vertices());
    for (std::size_t v = 0; v < points.size(); ++v)
      for (std::size_t k = 0; k < 3; ++k)
        points[v][k] = static_cast<double>(
            detail::Components<Point>::get(mesh.point(handle(static_cast<int>(v))), k));
    return points;
  }
  static typename Mesh::VertexHandle handle(int v) { return typename Mesh::VertexHandle(v); }

  void find_grids(const Mesh& mesh) {
    patches_.reset();
    patches_ = recover_grids(detail::mesh_faces(mesh), static_cast<int>(mesh.n_vertices()),
                             positions(mesh));
    fingerprint_ = detail::fingerprint(mesh);
  }

  void refine(Mesh& mesh, std::size_t levels, bool update_points) {
    const std::vector<Point3> old_positions = positions(mesh);
    std::vector<GridPatch> patches;
    for (const GridPatch& patch : *patches_) patches.push_back(oriented(patch, old_positions));
    const detail::RebuildOptions options =
        detail::rebuild_options(*along_rows_, *along_cols_, boundaries_,
                                static_cast<int>(std::min<std::size_t>(levels, 64)), on_limit_);
    const detail::Rebuild rebuild =
        detail::plan_rebuild(std::move(patches), static_cast<int>(mesh.n_vertices()), options);
    const AttributeRule points_rule = update_points ? rules_.points : AttributeRule::linear;
    if (points_rule == AttributeRule::nearest)
      throw InvalidField("points cannot follow the rule nearest; use scheme or linear");
    const Evaluators evaluators = make_evaluators<Real>(rebuild);
    const auto attribute_evaluators = make_evaluators<double>(rebuild);
    const auto frames = points_rule == AttributeRule::scheme && mesh.has_vertex_normals()
                            ? limit_stencils()
                            : std::nullopt;

    // Nothing has been changed so far; from here on nothing can go wrong but memory running out.
    auto& points = mesh.property(mesh.points_property_handle());
    const std::vector<Point> old_points = points.data_vector();
    const auto skipped = properties_done_otherwise(mesh);
    const auto lone_normals = normals_of_lone_vertices(mesh, rebuild);
    auto jobs = detail::vertex_jobs(
        mesh, rebuild, attribute_evaluators, rules_, skipped,
        [&](::OpenMesh::BaseProperty& property, AttributeRule rule, detail::ValueRange range) {
          return traits_job(property, rule, range, rebuild, attribute_evaluators);
        });
    for (auto& job : detail::corner_jobs(mesh, rebuild, skipped)) jobs.push_back(std::move(job));
    detail::refine_edge_attributes(mesh, rebuild, skipped);
    detail::refine_face_attributes(mesh, rebuild, skipped);

    detail::build_connectivity(mesh, rebuild, threads_);
    detail::refine_vertex_values(rebuild, evaluators, points_rule, {}, old_points,
                                 points.data_vector());
    for (const detail::Job& job : jobs) job();
    if (mesh.has_vertex_normals()) {
      detail::set_vertex_normals(mesh, rebuild, options, frames, old_positions, threads_);
      for (const auto& [vertex, normal] : lone_normals) mesh.set_normal(handle(vertex), normal);
    }
    if (mesh.has_face_normals())
      for (auto face : mesh.faces()) mesh.set_normal(face, mesh.calc_face_normal(face));
  }

  template <class T>
  std::vector<detail::PatchEvaluator<T>> make_evaluators(const detail::Rebuild& rebuild) const {
    std::vector<detail::PatchEvaluator<T>> evaluators;
    for (const detail::RefinedPatch& patch : rebuild.patches)
      evaluators.emplace_back(patch, threads_);
    return evaluators;
  }

  // Points and normals are computed here; the data of traits that add none are empty structs.
  static std::set<const ::OpenMesh::BaseProperty*> properties_done_otherwise(Mesh& mesh) {
    std::set<const ::OpenMesh::BaseProperty*> done{&mesh.property(mesh.points_property_handle())};
    if (mesh.has_vertex_normals()) done.insert(&mesh.property(mesh.vertex_normals_pph()));
    if (mesh.has_face_normals()) done.insert(&mesh.property(mesh.face_normals_pph()));
    const auto skip_empty = [&]<class Data>(auto begin, auto end, const Data*) {
      if constexpr (std::is_empty_v<Data>)
        for (auto it = begin; it != end; ++it)
          if (dynamic_cast<::OpenMesh::PropertyT<Data>*>(*it)) done.insert(*it);
    };
    using V = typename Mesh::VertexData;
    using H = typename Mesh::HalfedgeData;
    using E = typename Mesh::EdgeData;
    using F = typename Mesh::FaceData;
    skip_empty(mesh.vprops_begin(), mesh.vprops_end(), static_cast<const V*>(nullptr));
    skip_empty(mesh.hprops_begin(), mesh.hprops_end(), static_cast<const H*>(nullptr));
    skip_empty(mesh.eprops_begin(), mesh.eprops_end(), static_cast<const E*>(nullptr));
    skip_empty(mesh.fprops_begin(), mesh.fprops_end(), static_cast<const F*>(nullptr));
    return done;
  }

  static std::vector<std::pair<int, typename Mesh::Normal>> normals_of_lone_vertices(
      const Mesh& mesh, const detail::Rebuild& rebuild) {
    std::vector<std::pair<int, typename Mesh::Normal>> normals;
    if (mesh.has_vertex_normals())
      for (const auto& [old_number, new_number] : rebuild.lone_vertices)
        normals.emplace_back(new_number, mesh.normal(handle(old_number)));
    return normals;
  }

  // Vector types of the mesh's own traits.
  static detail::Job traits_job(::OpenMesh::BaseProperty& property, AttributeRule rule,
                                detail::ValueRange range, const detail::Rebuild& rebuild,
                                const std::vector<detail::PatchEvaluator<double>>& evaluators) {
    detail::Job job;
    const auto attempt = [&]<class T>(const T*) {
      if constexpr (detail::HasComponents<T>) {
        auto* typed = dynamic_cast<::OpenMesh::PropertyT<T>*>(&property);
        if (!typed || job) return;
        job = [&rebuild, &evaluators, typed, rule, range, old = typed->data_vector()] {
          detail::refine_vertex_values(rebuild, evaluators, rule, range, old, typed->data_vector());
        };
      }
    };
    attempt(static_cast<const Point*>(nullptr));
    attempt(static_cast<const typename Mesh::Normal*>(nullptr));
    attempt(static_cast<const typename Mesh::Color*>(nullptr));
    attempt(static_cast<const typename Mesh::TexCoord1D*>(nullptr));
    attempt(static_cast<const typename Mesh::TexCoord2D*>(nullptr));
    attempt(static_cast<const typename Mesh::TexCoord3D*>(nullptr));
    return job;
  }

  // Both axes' stencils, found once a scheme: proving C^1 may take a while.
  std::optional<detail::Frames> limit_stencils() {
    if (!stencils_known_) {
      stencils_.reset();
      const auto rows = detail::limit_stencils(*along_rows_);
      const auto cols = *along_rows_ == *along_cols_ ? rows : detail::limit_stencils(*along_cols_);
      if (rows && cols) stencils_ = detail::Frames{*rows, *cols};
      stencils_known_ = true;
    }
    return stencils_;
  }

  std::optional<Scheme> along_rows_;
  std::optional<Scheme> along_cols_;
  std::string name_;
  Boundaries boundaries_;
  AttributeRules rules_;
  bool on_limit_ = false;
  int threads_ = 1;
  std::optional<std::vector<GridPatch>> patches_;
  std::uint64_t fingerprint_ = 0;
  bool stencils_known_ = false;
  std::optional<detail::Frames> stencils_;
};

}  // namespace arete::openmesh
