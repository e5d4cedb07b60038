// SPDX-License-Identifier: MIT
// Minimal surfaces as OpenMesh meshes.
#include "arete/openmesh/minimal_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "host_mesh.h"

namespace arete {
namespace {

using test::PolyMesh;
using test::TriMesh;

// Two rings of radius cosh(1/2) at heights -1/2 and 1/2: between them lies a catenoid.
PatchBoundary catenoid() {
  std::vector<Point3> low;
  std::vector<Point3> high;
  for (int k = 0; k < 64; ++k) {
    const double angle = 2 * std::numbers::pi * k / 64;
    const double radius = std::cosh(0.5);
    low.push_back({radius * std::cos(angle), radius * std::sin(angle), -0.5});
    high.push_back({radius * std::cos(angle), radius * std::sin(angle), 0.5});
  }
  return ring_boundary(low, high, true);
}

template <class Mesh>
double area_of(const Mesh& mesh) {
  double area = 0;
  for (auto f : mesh.faces()) {
    std::vector<OpenMesh::Vec3d> p;
    for (auto v : mesh.fv_range(f))
      p.push_back(OpenMesh::vector_cast<OpenMesh::Vec3d>(mesh.point(v)));
    for (std::size_t i = 2; i < p.size(); ++i)
      area += ((p[i - 1] - p[0]) % (p[i] - p[0])).norm() / 2;
  }
  return area;
}

template <class Mesh>
void expect_catenoid(const Mesh& mesh) {
  for (auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    EXPECT_NEAR(std::hypot(p[0], p[1]), std::cosh(p[2]), 0.01);
  }
  EXPECT_NEAR(area_of(mesh), std::numbers::pi * (1 + std::sinh(1.0)), 0.02);
}

TEST(openmesh_minimal, two_rings_span_a_catenoid_of_triangles_or_quads) {
  TriMesh triangles;
  PolyMesh quads;
  const auto levels = openmesh::minimal_surface(triangles, catenoid(), {.levels = 3});
  (void)openmesh::minimal_surface(quads, catenoid(), {.levels = 3}, openmesh::SurfaceFaces::quads);
  test::expect_sound(triangles);
  test::expect_sound(quads);
  EXPECT_EQ(triangles.n_faces(), 2 * quads.n_faces());
  for (auto f : quads.faces()) EXPECT_EQ(quads.valence(f), 4U);
  expect_catenoid(triangles);
  expect_catenoid(quads);
  ASSERT_EQ(levels.size(), 4U);
  EXPECT_TRUE(levels.back().converged);
  EXPECT_NEAR(levels.back().area, area_of(triangles), 1e-12);
}

TEST(openmesh_minimal, a_mesh_with_a_fixed_boundary_finds_the_same_area) {
  // A straight tube between the rings; its boundary stays.
  TriMesh mesh;
  (void)openmesh::minimal_surface(mesh, catenoid(), {.levels = 3, .relax = {.normal_steps = 0}});
  TriMesh disturbed = mesh;
  for (auto v : disturbed.vertices())
    if (!disturbed.is_boundary(v))
      disturbed.set_point(v, disturbed.point(v) * (1 + 0.05 * std::sin(7.0 * v.idx())));
  const double before = area_of(disturbed);
  const auto report = openmesh::relax_to_minimal(disturbed);
  EXPECT_TRUE(report.converged);
  EXPECT_LT(area_of(disturbed), before);
  EXPECT_NEAR(area_of(disturbed), report.areas.back(), 1e-12);
  expect_catenoid(disturbed);
  for (auto v : mesh.vertices())
    if (mesh.is_boundary(v)) {
      EXPECT_EQ(disturbed.point(v), mesh.point(v));
    }
}

TEST(openmesh_minimal, locked_vertices_stay) {
  test::FloatMesh mesh;
  (void)openmesh::minimal_surface(mesh, catenoid(), {.levels = 1});
  mesh.request_vertex_status();
  OpenMesh::VertexHandle locked;
  for (auto v : mesh.vertices())
    if (!mesh.is_boundary(v)) locked = v;
  mesh.set_point(locked, mesh.point(locked) * 1.3F);
  mesh.status(locked).set_locked(true);
  const auto place = mesh.point(locked);
  (void)openmesh::relax_to_minimal(mesh);
  EXPECT_EQ(mesh.point(locked), place);
}

TEST(openmesh_minimal, what_has_no_fixed_vertex_is_refused_and_left_as_it_was) {
  TriMesh mesh;  // a closed tetrahedron would shrink to a point
  std::vector<TriMesh::VertexHandle> v;
  for (const auto& p : {OpenMesh::Vec3d(0, 0, 0), OpenMesh::Vec3d(1, 0, 0),
                        OpenMesh::Vec3d(0, 1, 0), OpenMesh::Vec3d(0, 0, 1)})
    v.push_back(mesh.add_vertex(p));
  mesh.add_face(v[0], v[2], v[1]);
  mesh.add_face(v[0], v[1], v[3]);
  mesh.add_face(v[1], v[2], v[3]);
  mesh.add_face(v[2], v[0], v[3]);
  EXPECT_THROW((void)openmesh::relax_to_minimal(mesh), InvalidField);
  EXPECT_EQ(mesh.point(v[3]), OpenMesh::Vec3d(0, 0, 1));
}

}  // namespace
}  // namespace arete
