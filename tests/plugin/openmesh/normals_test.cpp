// SPDX-License-Identifier: MIT
#include <cmath>

#include "plugin/openmesh/host_mesh.h"
#include "support/schemes.h"

namespace arete {
namespace {

using openmesh::GridSubdividerT;
using test::Mesh;
using test::PolyMesh;

// A terrain of the given heights, so wide that the middle feels no rim.
Mesh surface(double (*height)(double, double)) {
  Mesh mesh = test::terrain_mesh(17, 17);
  for (Point3& p : mesh.points) p[2] = height(p[0], p[1]);
  return mesh;
}

bool in_the_middle(const OpenMesh::Vec3d& p) {
  return std::abs(p[0] - 8) < 3 && std::abs(p[1] + 8) < 3;
}

TEST(openmesh_normals, are_those_of_the_limit_surface) {
  // Schemes that reproduce quadratics, or shift them by a constant: the limit of x^2 - xy / 2 has
  // the derivatives 2 x - y / 2 and -x / 2.
  for (const char* name : {"four-point", "b-spline:degree=3", "dubuc-deslauriers:points=6",
                           "ternary-four-point:mu=1/10", "b-spline:degree=5"}) {
    PolyMesh mesh;
    test::fill(mesh,
               test::shuffled(surface([](double x, double y) { return x * x - x * y / 2; }), 3));
    mesh.request_vertex_normals();
    GridSubdividerT<PolyMesh> subdivide(name);
    ASSERT_TRUE(subdivide(mesh, 2));
    int compared = 0;
    for (auto v : mesh.vertices()) {
      const auto& p = mesh.point(v);
      if (!in_the_middle(p)) continue;
      OpenMesh::Vec3d expected(-2 * p[0] + p[1] / 2, p[0] / 2, 1);
      expected.normalize();
      EXPECT_LT((mesh.normal(v) - expected).norm(), 1e-11) << name << " at " << p;
      ++compared;
    }
    EXPECT_GT(compared, 300);
  }
}

TEST(openmesh_normals, do_not_depend_on_the_level) {
  // The limit at old vertices is the same whichever level it is asked at.
  const Mesh plain = test::terrain_mesh(7, 7);
  PolyMesh coarse, fine;
  test::fill(coarse, plain);
  test::fill(fine, plain);
  coarse.request_vertex_normals();
  fine.request_vertex_normals();
  GridSubdividerT<PolyMesh> subdivide("gentle");
  ASSERT_TRUE(subdivide(coarse, 1));
  ASSERT_TRUE(subdivide(fine, 4));
  for (int v = 0; v < plain.vertices(); ++v) {
    const PolyMesh::VertexHandle handle(v);
    EXPECT_LT((coarse.normal(handle) - fine.normal(handle)).norm(), 1e-11);
  }
}

TEST(openmesh_normals, of_a_plane_are_its_own_under_every_scheme) {
  for (const Scheme& scheme : test::sample_schemes()) {
    PolyMesh mesh;
    test::fill(mesh, surface([](double x, double y) { return 0.5 * x - 0.25 * y; }));
    mesh.request_vertex_normals();
    GridSubdividerT<PolyMesh> subdivide(scheme);
    ASSERT_TRUE(subdivide(mesh, 1));
    OpenMesh::Vec3d expected(-0.5, 0.25, 1);
    expected.normalize();
    for (auto v : mesh.vertices())
      EXPECT_LT((mesh.normal(v) - expected).norm(), 1e-12) << scheme.text();
  }
}

TEST(openmesh_normals, look_where_the_faces_look) {
  for (const char* name : {"four-point", "chaikin", "craggy"}) {
    for (Mesh plain : {test::terrain_mesh(5, 6), test::tube_mesh(4, 9), test::torus_mesh(7, 9)}) {
      for (bool turned : {false, true}) {
        if (turned) plain = test::turned_over(plain);
        PolyMesh mesh;
        test::fill(mesh, test::shuffled(plain, 7));
        mesh.request_face_normals();
        mesh.request_vertex_normals();
        GridSubdividerT<PolyMesh> subdivide(name);
        ASSERT_TRUE(subdivide(mesh, 3));
        for (auto f : mesh.faces()) {
          const auto n = mesh.calc_face_normal(f);
          EXPECT_LT((mesh.normal(f) - n).norm(), 1e-12);
          if (std::string(name) == "craggy") continue;  // no tangent plane to agree with
          for (auto v : f.vertices()) EXPECT_GT(mesh.normal(v) | n, 0.5) << name;
        }
      }
    }
  }
}

}  // namespace
}  // namespace arete
