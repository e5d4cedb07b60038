// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "arete/openmesh/internal/components.h"
#include "arete/variational/boundary_loop.h"
#include "arete/variational/minimal_patch.h"

namespace arete::openmesh {

/// How a new surface's quads become faces.
enum class SurfaceFaces { quads, triangles };

/// A surface of least area as a mesh of its own, from coarse to fine (see minimal_surface):
///
///     auto loop = ...;                                   // std::vector<arete::Point3>
///     auto boundary = arete::patch_boundary(loop, {}, true);   // or ring_boundary, or any four
///     curves Mesh mesh; auto levels = arete::openmesh::minimal_surface(mesh, boundary, {.levels =
///     4});
///
/// The mesh is cleared first; vertices are the samples row by row. Returns what was done on every
/// level: area, largest mean curvature, steps. \throws InvalidField as arete::minimal_surface.
template <class Mesh>
std::vector<MinimalLevel> minimal_surface(Mesh& mesh, const PatchBoundary& boundary,
                                          const MinimalOptions& options = {},
                                          SurfaceFaces faces = SurfaceFaces::triangles) {
  using Point = typename Mesh::Point;
  using C = detail::Components<Point>;
  const MinimalSurface surface = arete::minimal_surface(boundary, options);
  mesh.clear();
  std::vector<typename Mesh::VertexHandle> vertices;
  for (const Point3& p : surface.mesh.points) {
    Point point{};
    for (std::size_t k = 0; k < 3; ++k) C::set(point, k, static_cast<typename C::Scalar>(p[k]));
    vertices.push_back(mesh.add_vertex(point));
  }
  const auto corner = [&](int i) { return vertices[static_cast<std::size_t>(i)]; };
  const auto& triangles = surface.mesh.triangles;
  // A quad (a, b, e, d) is cut into (a, b, e) and (a, e, d).
  const bool quads = faces == SurfaceFaces::quads;
  for (std::size_t t = 0; t < triangles.size(); t += quads ? 2 : 1) {
    const auto& [a, b, e] = triangles[t];
    std::vector<typename Mesh::VertexHandle> face{corner(a), corner(b), corner(e)};
    if (quads) face.push_back(corner(triangles[t + 1][2]));
    mesh.add_face(face);
  }
  return surface.levels;
}

/// Moves the inner vertices of a mesh until its area is stationary (see relax); boundary vertices
/// and those that are locked or features (where the mesh has vertex status) stay. Faces of more
/// than three corners count as the triangles around their first one. Connectivity and attributes
/// are left alone, normals too. \throws InvalidField as relax; the mesh is then as it was.
template <class Mesh>
RelaxReport relax_to_minimal(Mesh& mesh, const RelaxOptions& options = {}) {
  using Point = typename Mesh::Point;
  using C = detail::Components<Point>;
  SurfaceMesh surface;
  for (auto v : mesh.vertices()) {
    Point3 p{};
    for (std::size_t k = 0; k < 3; ++k) p[k] = static_cast<double>(C::get(mesh.point(v), k));
    surface.points.push_back(p);
    bool held = mesh.is_boundary(v);
    if (mesh.has_vertex_status())
      held = held || mesh.status(v).locked() || mesh.status(v).feature();
    surface.fixed.push_back(held);
  }
  for (auto f : mesh.faces()) {
    std::vector<int> corners;
    for (auto v : mesh.fv_range(f)) corners.push_back(v.idx());
    for (std::size_t i = 2; i < corners.size(); ++i)
      surface.triangles.push_back({corners[0], corners[i - 1], corners[i]});
  }
  RelaxReport report = relax(surface, options);
  for (auto v : mesh.vertices()) {
    const auto i = static_cast<std::size_t>(v.idx());
    if (surface.fixed[i]) continue;
    Point point = mesh.point(v);
    for (std::size_t k = 0; k < 3; ++k)
      C::set(point, k, static_cast<typename C::Scalar>(surface.points[i][k]));
    mesh.set_point(v, point);
  }
  return report;
}

}  // namespace arete::openmesh
