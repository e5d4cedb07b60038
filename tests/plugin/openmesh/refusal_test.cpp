// SPDX-License-Identifier: MIT
#include "plugin/openmesh/host_mesh.h"

namespace arete {
namespace {

using openmesh::GridSubdividerT;
using test::Mesh;
using test::PolyMesh;

void expect_refused(PolyMesh& mesh, GridSubdividerT<PolyMesh>& subdivide, const std::string& text,
                    std::size_t levels = 1) {
  const Mesh before = test::plain(mesh);
  const test::Complaints complaints;
  EXPECT_FALSE(subdivide(mesh, levels));
  EXPECT_NE(complaints.text().find(text), std::string::npos) << complaints.text();
  const Mesh after = test::plain(mesh);
  EXPECT_EQ(before.points, after.points);
  EXPECT_EQ(before.faces.corners, after.faces.corners);
  EXPECT_EQ(before.faces.starts, after.faces.starts);
}

TEST(openmesh_refusals, what_is_no_grid_is_named_and_left_alone) {
  const Mesh grid = test::terrain_mesh(5, 5);
  PolyMesh mesh;
  test::fill(mesh, test::without_faces(grid, {5}));
  GridSubdividerT<PolyMesh> catmull_clark;
  expect_refused(mesh, catmull_clark, "vertex 6 on the rim has 3 faces");
  expect_refused(mesh, catmull_clark, "use OpenSubdiv or CGAL");
  GridSubdividerT<PolyMesh> craggy("craggy");
  expect_refused(mesh, craggy, "arete craggy: vertex 6");

  const test::Complaints complaints;
  EXPECT_FALSE(craggy.attach(mesh));
  EXPECT_FALSE(craggy(1)) << "an unfit mesh is not attached";
}

TEST(openmesh_refusals, deleted_elements_must_be_collected_first) {
  PolyMesh mesh;
  mesh.request_vertex_status();
  mesh.request_edge_status();
  mesh.request_face_status();
  test::fill(mesh, test::terrain_mesh(3, 4));
  mesh.delete_vertex(PolyMesh::VertexHandle(3));
  mesh.delete_vertex(PolyMesh::VertexHandle(7));
  mesh.delete_vertex(PolyMesh::VertexHandle(11));
  GridSubdividerT<PolyMesh> subdivide("four-point");
  {
    const test::Complaints complaints;
    EXPECT_FALSE(subdivide(mesh, 1));
    EXPECT_NE(complaints.text().find("garbage_collection"), std::string::npos);
  }
  mesh.garbage_collection();
  EXPECT_TRUE(subdivide(mesh, 1));
  EXPECT_EQ(mesh.n_vertices(), 25u);
  test::expect_sound(mesh);
}

TEST(openmesh_refusals, what_cannot_be_numbered_or_bounded_is_refused_before_it_is_begun) {
  PolyMesh mesh;
  test::fill(mesh, test::terrain_mesh(4, 4));
  GridSubdividerT<PolyMesh> subdivide("four-point");
  expect_refused(mesh, subdivide, "use fewer levels", 15);
  expect_refused(mesh, subdivide, "use fewer levels", 1000000);
  subdivide.set_boundaries({Boundary::periodic, Boundary::clamp});
  expect_refused(mesh, subdivide, "choose the rule of the open rims");
  subdivide.set_boundaries({Boundary::none, Boundary::none});
  subdivide.set_scheme(parse_scheme("dubuc-deslauriers:points=8"));
  expect_refused(mesh, subdivide, "boundary none");
  subdivide.set_boundaries({});
  subdivide.rules().points = openmesh::AttributeRule::nearest;
  expect_refused(mesh, subdivide, "nearest");
  EXPECT_THROW(GridSubdividerT<PolyMesh>("fourpoint"), std::exception);
}

TEST(openmesh_refusals, nothing_to_do_is_no_error) {
  PolyMesh empty;
  GridSubdividerT<PolyMesh> subdivide;
  EXPECT_TRUE(subdivide(empty, 3));
  EXPECT_EQ(empty.n_vertices(), 0u);
  empty.add_vertex({1, 2, 3});
  EXPECT_TRUE(subdivide(empty, 3));
  EXPECT_EQ(empty.n_vertices(), 1u);
  PolyMesh mesh;
  test::fill(mesh, test::terrain_mesh(3, 3));
  const Mesh before = test::plain(mesh);
  EXPECT_TRUE(subdivide(mesh, 0));
  EXPECT_EQ(test::plain(mesh).points, before.points);
}

TEST(openmesh_refusals, boundary_none_shrinks_the_grid) {
  PolyMesh mesh;
  test::fill(mesh, test::terrain_mesh(8, 9));
  mesh.request_vertex_texcoords2D();
  OpenMesh::VPropHandleT<std::string> label;
  mesh.add_property(label, "label");
  for (auto v : mesh.vertices()) {
    mesh.set_texcoord2D(v, {mesh.point(v)[0], mesh.point(v)[1]});
    mesh.property(label, v) = std::to_string(v.idx());
  }
  GridSubdividerT<PolyMesh> subdivide("four-point");
  subdivide.set_boundaries({Boundary::none, Boundary::none});
  ASSERT_TRUE(subdivide(mesh, 1));
  test::expect_sound(mesh);
  EXPECT_EQ(mesh.n_vertices(), (2u * 8 - 5) * (2 * 9 - 5));
  for (auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    EXPECT_NEAR(mesh.texcoord2D(v)[0], p[0], 1e-12);
    EXPECT_NEAR(mesh.texcoord2D(v)[1], p[1], 1e-12);
    if (p[0] == std::floor(p[0]) && p[1] == std::floor(p[1])) {
      EXPECT_EQ(mesh.property(label, v), std::to_string(std::lround(-p[1] * 9 + p[0])));
    }
  }
}

}  // namespace
}  // namespace arete
