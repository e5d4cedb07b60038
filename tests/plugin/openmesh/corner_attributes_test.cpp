// SPDX-License-Identifier: MIT
// Half-edge attributes: values that belong to the corners of faces.
#include <cmath>

#include "plugin/openmesh/host_mesh.h"

namespace arete {
namespace {

using openmesh::GridSubdividerT;
using test::Mesh;
using test::PolyMesh;

// Texture coordinates that jump by 10 across the line x = 2 and are linear on either side.
OpenMesh::Vec2d texcoord(const OpenMesh::Vec3d& p, bool east) {
  return {p[0] + (east ? 10 : 0), 2 * p[1] - p[0]};
}

template <class Host>
bool lies_east(const Host& mesh, typename Host::FaceHandle face) {
  return mesh.calc_face_centroid(face)[0] > 2;
}

template <class Host>
void expect_seam_kept(const Mesh& plain, const char* scheme) {
  Host mesh;
  test::fill(mesh, plain);
  mesh.request_halfedge_texcoords2D();
  for (auto h : mesh.halfedges())
    if (!mesh.is_boundary(h))
      mesh.set_texcoord2D(h, texcoord(mesh.point(h.to()), lies_east(mesh, h.face())));
  GridSubdividerT<Host> subdivide(scheme);
  ASSERT_TRUE(subdivide(mesh, 2, false));
  int seam = 0;
  for (auto h : mesh.halfedges()) {
    const auto value = mesh.texcoord2D(h);
    if (mesh.is_boundary(h)) {
      EXPECT_EQ(value, OpenMesh::Vec2d(0, 0));
      continue;
    }
    const auto expected = texcoord(mesh.point(h.to()), lies_east(mesh, h.face()));
    EXPECT_NEAR(value[0], expected[0], 1e-12) << scheme;
    EXPECT_NEAR(value[1], expected[1], 1e-12) << scheme;
    if (std::abs(mesh.point(h.to())[0] - 2) < 1e-9) ++seam;
  }
  if (std::string(scheme) != "b-spline:degree=2") {
    EXPECT_GT(seam, 20);
  }
}

TEST(openmesh_corners, texcoords_are_linear_and_a_seam_stays_a_seam) {
  const Mesh quads = test::terrain_mesh(4, 5);
  std::mt19937 random(9);
  const Mesh cut = test::triangulated(quads, [&](int) { return random() % 2 == 0; });
  for (const char* scheme : {"four-point", "ternary-two-step-9", "b-spline:degree=3"}) {
    for (unsigned seed = 0; seed < 5; ++seed) {
      expect_seam_kept<PolyMesh>(test::shuffled(quads, seed), scheme);
      expect_seam_kept<PolyMesh>(test::shuffled(cut, seed), scheme);
      expect_seam_kept<test::TriMesh>(test::shuffled(cut, seed), scheme);
    }
  }
}

TEST(openmesh_corners, a_face_across_old_faces_takes_the_side_of_its_middle) {
  // Chaikin's cells straddle old lines; along y the field is linear everywhere.
  PolyMesh mesh;
  test::fill(mesh, test::terrain_mesh(5, 5));
  OpenMesh::HPropHandleT<double> height;
  mesh.add_property(height, "height");
  for (auto h : mesh.halfedges()) mesh.property(height, h) = mesh.point(h.to())[1];
  GridSubdividerT<PolyMesh> subdivide("chaikin");
  ASSERT_TRUE(subdivide(mesh, 2, false));
  for (auto h : mesh.halfedges()) {
    if (!mesh.is_boundary(h)) {
      EXPECT_NEAR(mesh.property(height, h), mesh.point(h.to())[1], 1e-12);
    }
  }
}

TEST(openmesh_corners, a_tube_unrolls_without_a_jump_inside_any_face) {
  Mesh plain = test::tube_mesh(3, 8);
  PolyMesh mesh;
  test::fill(mesh, plain);
  mesh.request_halfedge_texcoords2D();
  // u runs 0..8 round, the last face from 7 to 8.
  for (auto f : mesh.faces()) {
    const int first = f.idx() % 8;
    for (auto h : f.halfedges()) {
      const int column = h.to().idx() % 8;
      mesh.set_texcoord2D(h, {column == first ? first : first + 1, h.to().idx() / 8});
    }
  }
  GridSubdividerT<PolyMesh> subdivide("b-spline:degree=3");
  ASSERT_TRUE(subdivide(mesh, 2));
  double area = 0;
  for (auto f : mesh.faces()) {
    double low = 1e9, high = -1e9;
    for (auto h : f.halfedges()) {
      low = std::min(low, mesh.texcoord2D(h)[0]);
      high = std::max(high, mesh.texcoord2D(h)[0]);
    }
    EXPECT_NEAR(high - low, 0.25, 1e-12);
    area += (high - low) * 0.25;
  }
  EXPECT_NEAR(area, 16, 1e-9);
}

TEST(openmesh_corners, normals_of_corners_stay_unit_vectors) {
  PolyMesh mesh;
  test::fill(mesh, test::terrain_mesh(4, 4));
  mesh.request_face_normals();
  mesh.request_halfedge_normals();
  mesh.update_face_normals();
  mesh.update_halfedge_normals(0.3);
  GridSubdividerT<PolyMesh> subdivide("gentle");
  ASSERT_TRUE(subdivide(mesh, 2));
  for (auto h : mesh.halfedges()) {
    if (!mesh.is_boundary(h)) {
      EXPECT_NEAR(mesh.normal(h).norm(), 1, 1e-12);
    }
  }
}

}  // namespace
}  // namespace arete
