// SPDX-License-Identifier: MIT
// ReverseSubdividerT: what OpenMesh's own subdividers made comes back, with everything attached.
#include "arete/openmesh/reverse_subdivider.h"

#include <gtest/gtest.h>

#include <OpenMesh/Tools/Subdivider/Uniform/CatmullClarkT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <string>

#include "host_mesh.h"
#include "reverse/meshes.h"
#include "reverse/same_mesh.h"

namespace arete {
namespace {

using openmesh::ReverseSubdividerT;
using test::Complaints;
using test::expect_sound;
using test::PolyMesh;
using test::TriMesh;

constexpr ReverseMode modes[] = {ReverseMode::local, ReverseMode::least_squares};

template <class Host>
Host host_of(const MeshFaces& faces, const Grid<double>& positions) {
  Host host;
  for (Index v = 0; v < faces.vertices; ++v)
    host.add_vertex(typename Host::Point(static_cast<float>(positions(v, 0)),
                                         static_cast<float>(positions(v, 1)),
                                         static_cast<float>(positions(v, 2))));
  for (const auto& face : faces.faces) {
    std::vector<typename Host::VertexHandle> corners;
    for (const Index v : face) corners.emplace_back(static_cast<int>(v));
    EXPECT_TRUE(host.add_face(corners).is_valid());
  }
  return host;
}

template <class Host>
test::PlacedMesh placed(const Host& host) {
  test::PlacedMesh mesh{openmesh::detail::plain_faces(host),
                        Grid<double>({static_cast<Index>(host.n_vertices()), 3})};
  for (auto v : host.vertices())
    for (int k = 0; k < 3; ++k) mesh.positions(v.idx(), k) = host.point(v)[k];
  return mesh;
}

template <class Host, class Subdivider>
void expect_back(MeshScheme scheme) {
  for (const auto& [name, faces] : test::control_meshes(scheme)) {
    const Host control = host_of<Host>(faces, test::random_positions(faces.vertices, 8));
    for (const std::size_t levels : {1U, 2U, 3U})
      for (const ReverseMode mode : modes) {
        Host mesh = control;
        Subdivider subdivide;
        ASSERT_TRUE(subdivide(mesh, levels));
        mesh.garbage_collection();
        const test::PlacedMesh fine = placed(mesh);
        ReverseSubdividerT<Host> reverse(scheme, mode);
        ASSERT_TRUE(reverse(mesh, levels)) << name;
        expect_sound(mesh);
        test::expect_same_mesh(placed(mesh), placed(control), 1e-10,
                               name + ", " + std::to_string(levels) + " levels");
        ASSERT_TRUE(reverse.restore(mesh));
        expect_sound(mesh);
        EXPECT_EQ(placed(mesh).positions.samples(), fine.positions.samples()) << name;
        EXPECT_EQ(placed(mesh).faces, fine.faces) << name;
      }
  }
}

TEST(openmesh_reverse, gives_back_the_control_mesh_of_openmeshs_loop) {
  expect_back<TriMesh, OpenMesh::Subdivider::Uniform::LoopT<TriMesh, double>>(MeshScheme::loop);
}

TEST(openmesh_reverse, gives_back_the_control_mesh_of_openmeshs_catmull_clark) {
  expect_back<PolyMesh, OpenMesh::Subdivider::Uniform::CatmullClarkT<PolyMesh, double>>(
      MeshScheme::catmull_clark);
}

TEST(openmesh_reverse, the_rim_of_openmeshs_catmull_clark_is_found_to_be_another) {
  PolyMesh mesh = host_of<PolyMesh>(test::open_grid(4, 5, false), test::random_positions(20, 8));
  OpenMesh::Subdivider::Uniform::CatmullClarkT<PolyMesh, double> subdivide;
  ASSERT_TRUE(subdivide(mesh, 1));
  ReverseSubdividerT<PolyMesh> reverse(MeshScheme::catmull_clark);
  ASSERT_TRUE(reverse(mesh, 1));
  EXPECT_EQ(reverse.level(0).rule.rim, MeshRim::thirds);
}

// A mesh of floats whose every element carries something.
struct Attached {
  OpenMesh::PolyMesh_ArrayKernelT<> mesh;
  OpenMesh::VPropHandleT<std::string> names;
  OpenMesh::FPropHandleT<int> faces;
  OpenMesh::EPropHandleT<int> edges;
  OpenMesh::HPropHandleT<int> corners;

  Attached(const MeshFaces& faces_of, const Grid<double>& positions)
      : mesh(host_of<OpenMesh::PolyMesh_ArrayKernelT<>>(faces_of, positions)) {
    mesh.request_vertex_colors();
    mesh.request_vertex_normals();
    mesh.request_face_normals();
    mesh.update_normals();
    mesh.add_property(names);
    mesh.add_property(faces);
    mesh.add_property(edges);
    mesh.add_property(corners);
    for (auto v : mesh.vertices()) {
      mesh.property(names, v) = "vertex " + std::to_string(v.idx());
      mesh.set_color(v, {static_cast<unsigned char>(v.idx()), 7, 9});
    }
    for (auto f : mesh.faces()) mesh.property(faces, f) = f.idx();
    for (auto e : mesh.edges()) mesh.property(edges, e) = e.idx();
    for (auto h : mesh.halfedges()) mesh.property(corners, h) = h.idx();
  }
};

TEST(openmesh_reverse, hands_attributes_over_and_gives_every_one_back) {
  for (const MeshScheme scheme :
       {MeshScheme::catmull_clark, MeshScheme::loop, MeshScheme::doo_sabin}) {
    const MeshFaces control = scheme == MeshScheme::doo_sabin
                                  ? test::torus(4, 3, false)
                                  : test::open_grid(4, 5, scheme == MeshScheme::loop);
    const auto step = mesh_step<double>(control, scheme);
    Attached before(step.fine, test::random_positions(step.fine.vertices, 3));
    Attached after = before;
    ReverseSubdividerT<OpenMesh::PolyMesh_ArrayKernelT<>> reverse(scheme);
    ASSERT_TRUE(reverse(after.mesh, 1));
    expect_sound(after.mesh);
    const auto& coarse = after.mesh;
    const auto& fine = before.mesh;
    ASSERT_EQ(static_cast<Index>(coarse.n_vertices()), control.vertices);
    const RecoveredMesh& recovered = reverse.level(0).mesh;
    const auto heirs = vertex_order(recovered, scheme);
    for (auto v : coarse.vertices()) {
      const auto heir = static_cast<int>(heirs[static_cast<std::size_t>(v.idx())]);
      EXPECT_EQ(coarse.property(after.names, v), "vertex " + std::to_string(heir));
      EXPECT_EQ(coarse.color(v)[0], static_cast<unsigned char>(heir));
      EXPECT_NEAR(OpenMesh::norm(coarse.normal(v)), 1, 1e-5);
      if (scheme != MeshScheme::doo_sabin) {
        EXPECT_EQ(recovered.place[static_cast<std::size_t>(v.idx())], heir);
      }
    }
    for (auto h : coarse.halfedges()) {
      // The fine half-edge ends in the fine vertex of the coarse one's end (Doo-Sabin: in the
      // corner of the same face), and its edge is the edge's own.
      const OpenMesh::HalfedgeHandle from(coarse.property(after.corners, h));
      const auto end = static_cast<std::size_t>(coarse.to_vertex_handle(h).idx());
      if (scheme != MeshScheme::doo_sabin) {
        EXPECT_EQ(fine.to_vertex_handle(from).idx(), heirs[end]);
        EXPECT_EQ(coarse.is_boundary(h), fine.is_boundary(from));
      }
      if (h.idx() % 2 == 0) {
        EXPECT_EQ(coarse.property(after.edges, coarse.edge_handle(h)), from.idx() / 2);
      }
      if (coarse.is_boundary(h)) continue;
      const auto parent = coarse.face_handle(h);
      if (scheme == MeshScheme::doo_sabin) {
        EXPECT_EQ(fine.face_handle(from).idx(), coarse.property(after.faces, parent));
      }
    }
    ASSERT_TRUE(reverse.restore(after.mesh));
    for (auto v : fine.vertices()) {
      EXPECT_EQ(coarse.point(v), fine.point(v));
      EXPECT_EQ(coarse.normal(v), fine.normal(v));
      EXPECT_EQ(coarse.color(v), fine.color(v));
      EXPECT_EQ(coarse.property(after.names, v), fine.property(before.names, v));
    }
    for (auto h : fine.halfedges()) {
      EXPECT_EQ(coarse.property(after.corners, h), h.idx());
      EXPECT_EQ(coarse.to_vertex_handle(h), fine.to_vertex_handle(h));
    }
  }
}

TEST(openmesh_reverse, a_moved_coarse_vertex_carries_its_details_along) {
  const MeshFaces control = test::torus(6, 5, false);
  const auto step = mesh_step<double>(control, MeshScheme::catmull_clark);
  PolyMesh mesh = host_of<PolyMesh>(step.fine, test::random_positions(step.fine.vertices, 2));
  const PolyMesh before = mesh;
  ReverseSubdividerT<PolyMesh> reverse(MeshScheme::catmull_clark);
  ASSERT_TRUE(reverse(mesh, 1));
  // Moving the whole control mesh moves the whole mesh.
  for (auto v : mesh.vertices()) mesh.set_point(v, mesh.point(v) + PolyMesh::Point(5, 0, -3));
  ASSERT_TRUE(reverse.restore(mesh));
  for (auto v : mesh.vertices())
    EXPECT_LE((mesh.point(v) - before.point(v) - PolyMesh::Point(5, 0, -3)).norm(), 1e-12);
}

TEST(openmesh_reverse, levels_are_put_back_one_by_one) {
  const MeshFaces control = test::prism(5);
  PolyMesh mesh = host_of<PolyMesh>(control, test::random_positions(10, 2));
  OpenMesh::Subdivider::Uniform::CatmullClarkT<PolyMesh, double> subdivide;
  std::vector<std::size_t> counts{mesh.n_vertices()};
  for (int level = 0; level < 3; ++level) {
    ASSERT_TRUE(subdivide(mesh, 1));
    counts.push_back(mesh.n_vertices());
  }
  ReverseSubdividerT<PolyMesh> reverse(MeshScheme::catmull_clark);
  ASSERT_TRUE(reverse(mesh, 1));
  ASSERT_TRUE(reverse(mesh, 2));
  EXPECT_EQ(mesh.n_vertices(), counts[0]);
  EXPECT_EQ(reverse.levels(), 3U);
  for (std::size_t level = 1; level <= 3; ++level) {
    ASSERT_TRUE(reverse.restore(mesh, 1));
    EXPECT_EQ(mesh.n_vertices(), counts[level]);
  }
  EXPECT_FALSE(reverse.restore(mesh, 1));
}

TEST(openmesh_reverse, what_cannot_be_undone_is_refused_and_left_as_it_was) {
  PolyMesh cube = host_of<PolyMesh>(test::prism(4), test::random_positions(8, 2));
  const test::PlacedMesh before = placed(cube);
  const auto refused = [&](MeshScheme scheme, std::size_t levels, const std::string& part) {
    Complaints complaints;
    ReverseSubdividerT<PolyMesh> reverse(scheme);
    EXPECT_FALSE(reverse(cube, levels));
    EXPECT_NE(complaints.text().find(part), std::string::npos) << complaints.text();
    EXPECT_EQ(placed(cube).faces, before.faces);
    EXPECT_EQ(placed(cube).positions.samples(), before.positions.samples());
    EXPECT_EQ(reverse.levels(), 0U);
  };
  refused(MeshScheme::catmull_clark, 1, "does not have the structure of Catmull-Clark");
  refused(MeshScheme::loop, 1, "face 0 has 4 corners, not 3");
  refused(MeshScheme::doo_sabin, 1, "vertex 0 has valence 3, not 4");
  cube.set_point(PolyMesh::VertexHandle(5), PolyMesh::Point(std::nan(""), 0, 0));
  Complaints complaints;
  ReverseSubdividerT<PolyMesh> reverse(MeshScheme::catmull_clark);
  EXPECT_FALSE(reverse(cube, 1));
  EXPECT_NE(complaints.text().find("vertex 5"), std::string::npos);
  // One level there is, a second there is not.
  PolyMesh fine = host_of<PolyMesh>(test::prism(5), test::random_positions(10, 2));
  OpenMesh::Subdivider::Uniform::CatmullClarkT<PolyMesh, double> subdivide;
  ASSERT_TRUE(subdivide(fine, 1));
  EXPECT_FALSE(reverse(fine, 2));
  EXPECT_NE(complaints.text().find("only 1 of 2 levels"), std::string::npos) << complaints.text();
}

}  // namespace
}  // namespace arete
