// SPDX-License-Identifier: MIT
#include "arete/openmesh/grid_subdivider.h"

#include "arete/openmesh/internal/edge_store.h"
#include "plugin/openmesh/host_mesh.h"
#include "support/schemes.h"

namespace arete {
namespace {

using openmesh::GridSubdividerT;
using test::Mesh;
using test::PolyMesh;

// x, y and z of the only patch as the grid engine refines them.
std::array<Grid<double>, 3> by_engine(const Mesh& mesh, const Scheme& scheme, int levels) {
  const GridPatch patch = test::oriented_patches(mesh).at(0);
  RefineOptions options;
  options.levels = levels;
  if (patch.wraps_cols) options.boundaries.x = Boundary::periodic;
  if (patch.wraps_rows) options.boundaries.y = Boundary::periodic;
  std::array<Grid<double>, 3> planes;
  for (std::size_t k = 0; k < 3; ++k)
    planes[k] = refine(test::plane_of(patch, mesh, k), scheme, options);
  return planes;
}

void expect_planes(const Mesh& mesh, const std::array<Grid<double>, 3>& expected,
                   const std::string& what) {
  const auto patches = test::oriented_patches(mesh);
  ASSERT_EQ(patches.size(), 1u) << what;
  ASSERT_EQ(patches[0].extent, expected[0].extent()) << what;
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_EQ(test::plane_of(patches[0], mesh, k).samples(), expected[k].samples()) << what;
}

TEST(openmesh, every_scheme_gives_what_the_grid_engine_gives) {
  const Mesh terrain = test::terrain_mesh(6, 9);
  for (const Scheme& scheme : test::sample_schemes()) {
    const int levels = scheme.mask().arity() > 3 ? 1 : 2;
    PolyMesh mesh;
    test::fill(mesh, terrain);
    GridSubdividerT<PolyMesh> subdivide(scheme);
    ASSERT_TRUE(subdivide(mesh, static_cast<std::size_t>(levels))) << scheme.text();
    test::expect_sound(mesh);
    expect_planes(test::plain(mesh), by_engine(terrain, scheme, levels), scheme.text());
    EXPECT_TRUE(test::oriented_patches(test::plain(mesh))[0].mirrored) << "faces turned over";
  }
}

TEST(openmesh, the_same_mesh_in_any_order_gives_the_same_surface) {
  const Mesh terrain = test::terrain_mesh(5, 8);
  // An asymmetric scheme, so that rows, columns and their directions matter.
  const Scheme scheme = parse_scheme("four-parameter:lambda=1/5,mu=1/10,nu=1/3,omega=1/7");
  const auto expected = by_engine(terrain, scheme, 2);
  for (unsigned seed = 0; seed < 60; ++seed) {
    PolyMesh quads;
    test::fill(quads, test::shuffled(terrain, seed));
    GridSubdividerT<PolyMesh> subdivide(scheme);
    ASSERT_TRUE(subdivide(quads, 2));
    expect_planes(test::plain(quads), expected, "quads " + std::to_string(seed));

    std::mt19937 random(seed);
    const Mesh cut = test::triangulated(terrain, [&](int) { return random() % 2 == 0; });
    test::TriMesh triangles;
    test::fill(triangles, test::shuffled(cut, seed));
    GridSubdividerT<test::TriMesh> subdivide_triangles(scheme);
    ASSERT_TRUE(subdivide_triangles(triangles, 2));
    test::expect_sound(triangles);
    expect_planes(test::plain(triangles), expected, "triangles " + std::to_string(seed));
  }
}

TEST(openmesh, old_vertices_keep_their_handles) {
  for (const char* name : {"four-point", "ternary-two-step-9", "b-spline:degree=3"}) {
    const bool interpolates = std::string(name) != "b-spline:degree=3";
    const Mesh terrain =
        test::shuffled(test::joined(test::terrain_mesh(4, 6), test::torus_mesh(5, 7)), 3);
    PolyMesh mesh;
    test::fill(mesh, terrain);
    GridSubdividerT<PolyMesh> subdivide(parse_scheme(name));
    // Bilinear points are the old ones at the old places, whatever the scheme.
    ASSERT_TRUE(subdivide(mesh, 1, interpolates));
    for (std::size_t v = 0; v < terrain.points.size(); ++v) {
      const auto& p = mesh.point(PolyMesh::VertexHandle(static_cast<int>(v)));
      for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(p[k], terrain.points[v][static_cast<std::size_t>(k)], 1e-14) << name;
    }
  }
}

TEST(openmesh, new_vertices_and_faces_follow_row_by_row) {
  PolyMesh mesh;
  test::fill(mesh, test::terrain_mesh(3, 3));
  GridSubdividerT<PolyMesh> subdivide("four-point");
  ASSERT_TRUE(subdivide(mesh, 1, false));
  // Row 0: old 0, new 9, old 1, new 10, old 2. Row 1: new 11 .. 15. Row 2 starts with old 3.
  using V = PolyMesh::VertexHandle;
  EXPECT_EQ(mesh.point(V(9)), OpenMesh::Vec3d(0.5, 0, mesh.point(V(9))[2]));
  EXPECT_EQ(mesh.point(V(10))[0], 1.5);
  EXPECT_EQ(mesh.point(V(11))[1], -0.5);
  EXPECT_EQ(mesh.point(V(15))[0], 2.0);
  EXPECT_EQ(mesh.point(V(16))[0], 0.5);
  for (auto face : mesh.faces()) {
    const auto centre = mesh.calc_face_centroid(face);
    EXPECT_EQ(face.idx(),
              std::lround((-centre[1] - 0.25) * 2) * 4 + std::lround((centre[0] - 0.25) * 2));
  }
}

TEST(openmesh, tubes_and_tori_stay_closed) {
  for (const char* name : {"four-point", "chaikin", "b-spline:degree=3", "ternary-four-point"}) {
    const Scheme scheme = parse_scheme(name);
    for (const Mesh& plain : {test::tube_mesh(4, 7), test::torus_mesh(5, 6)}) {
      for (unsigned seed = 0; seed < 5; ++seed) {
        PolyMesh mesh;
        const Mesh other = test::shuffled(plain, seed);
        test::fill(mesh, other);
        GridSubdividerT<PolyMesh> subdivide(scheme);
        ASSERT_TRUE(subdivide(mesh, 2)) << name;
        test::expect_sound(mesh);
        const auto expected = by_engine(other, scheme, 2);
        // The result may start elsewhere round, so compare as sets of points.
        std::vector<Point3> theirs;
        for (std::size_t i = 0; i < expected[0].samples().size(); ++i)
          theirs.push_back(
              {expected[0].samples()[i], expected[1].samples()[i], expected[2].samples()[i]});
        std::vector<Point3> ours = test::plain(mesh).points;
        std::sort(ours.begin(), ours.end());
        std::sort(theirs.begin(), theirs.end());
        EXPECT_EQ(ours, theirs) << name;
        const auto patch = test::oriented_patches(test::plain(mesh)).at(0);
        EXPECT_TRUE(patch.wraps_cols);
        const int euler = static_cast<int>(mesh.n_vertices()) - static_cast<int>(mesh.n_edges()) +
                          static_cast<int>(mesh.n_faces());
        EXPECT_EQ(euler, 0);
      }
    }
  }
}

TEST(openmesh, several_grids_and_lone_vertices_in_one_mesh) {
  Mesh plain = test::joined(test::terrain_mesh(3, 4), test::tube_mesh(3, 5));
  plain = test::joined(plain, test::terrain_mesh(2, 2));
  plain.points.push_back({7, 8, 9});
  for (const char* name : {"four-point", "chaikin"}) {
    for (unsigned seed = 0; seed < 10; ++seed) {
      std::vector<int> to;
      const Mesh other = test::shuffled(plain, seed, &to);
      PolyMesh mesh;
      test::fill(mesh, other);
      GridSubdividerT<PolyMesh> subdivide(name);
      ASSERT_TRUE(subdivide(mesh, 2));
      test::expect_sound(mesh);
      EXPECT_EQ(test::oriented_patches(test::plain(mesh)).size(), 3u);
      const bool primal = std::string(name) == "four-point";
      const PolyMesh::VertexHandle lone(primal ? to.back()
                                               : static_cast<int>(mesh.n_vertices()) - 1);
      EXPECT_TRUE(mesh.is_isolated(lone));
      EXPECT_EQ(mesh.point(lone), OpenMesh::Vec3d(7, 8, 9));
      const std::size_t expected =
          primal ? 9 * 13 + 9 * 20 + 5 * 5 + 1 : 8 * 12 + 8 * 20 + 4 * 4 + 1;
      EXPECT_EQ(mesh.n_vertices(), expected);
    }
  }
}

TEST(openmesh, both_call_forms_and_an_attached_mesh_refined_twice) {
  const Mesh terrain = test::terrain_mesh(4, 5);
  PolyMesh at_once, attached;
  test::fill(at_once, terrain);
  test::fill(attached, terrain);
  GridSubdividerT<PolyMesh> subdivide;
  EXPECT_TRUE(subdivide(at_once, 2));
  {
    GridSubdividerT<PolyMesh> other(attached);
    EXPECT_TRUE(other(1));
    EXPECT_TRUE(other(1));
    other.detach();
    EXPECT_FALSE(other(1));
  }
  // Extrapolation goes along with the cubic B-spline, so two steps are one call of two.
  const Mesh a = test::plain(at_once);
  const Mesh b = test::plain(attached);
  const auto pa = test::oriented_patches(a).at(0);
  const auto pb = test::oriented_patches(b).at(0);
  ASSERT_EQ(pa.extent, pb.extent);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto x = test::plane_of(pa, a, k).samples();
    const auto y = test::plane_of(pb, b, k).samples();
    for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(x[i], y[i], 1e-14);
  }
  EXPECT_STREQ(subdivide.name(), "arete b-spline:degree=3");
  EXPECT_STREQ(GridSubdividerT<PolyMesh>("four-point:omega=1/20").name(),
               "arete four-point:omega=1/20");
}

TEST(openmesh, connectivity_that_changed_after_attaching_is_seen) {
  PolyMesh mesh;
  test::fill(mesh, test::terrain_mesh(3, 3));
  GridSubdividerT<PolyMesh> subdivide(mesh);
  mesh.clear();
  test::fill(mesh, test::terrain_mesh(2, 6));
  EXPECT_TRUE(subdivide(1));
  EXPECT_EQ(mesh.n_vertices(), 3u * 11u);
}

TEST(openmesh, without_updating_points_the_shape_stays) {
  PolyMesh mesh;
  const Mesh terrain = test::terrain_mesh(4, 3);
  test::fill(mesh, terrain);
  GridSubdividerT<PolyMesh> subdivide("b-spline:degree=3");
  ASSERT_TRUE(subdivide(mesh, 2, false));
  const auto z = [&](long r, long c) {
    return terrain.points[static_cast<std::size_t>(3 * r + c)][2];
  };
  for (auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    const long c = std::min(1L, static_cast<long>(p[0]));
    const long r = std::min(2L, static_cast<long>(-p[1]));
    const double u = p[0] - static_cast<double>(c);
    const double w = -p[1] - static_cast<double>(r);
    EXPECT_NEAR(p[2],
                (1 - w) * ((1 - u) * z(r, c) + u * z(r, c + 1)) +
                    w * ((1 - u) * z(r + 1, c) + u * z(r + 1, c + 1)),
                1e-14);
  }
}

TEST(openmesh, two_schemes_and_boundaries_go_to_their_axes) {
  const Mesh terrain = test::terrain_mesh(6, 7);
  PolyMesh mesh;
  test::fill(mesh, terrain);
  const Scheme x = parse_scheme("three-point");
  const Scheme y = parse_scheme("ternary-four-point");
  GridSubdividerT<PolyMesh> subdivide;
  subdivide.set_schemes(x, y);
  subdivide.set_boundaries({Boundary::reflect, Boundary::clamp});
  ASSERT_TRUE(subdivide(mesh, 1));
  const GridPatch patch = test::oriented_patches(terrain).at(0);
  RefineOptions options;
  options.boundaries = {Boundary::reflect, Boundary::clamp};
  const Refiner<double> refiner(x, y, patch.extent, options);
  std::array<Grid<double>, 3> expected;
  for (std::size_t k = 0; k < 3; ++k)
    expected[k] = refiner(test::plane_of(patch, terrain, k).view());
  // Not to be turned again by its own shape: vertices are old ones first, so compare by sets.
  std::vector<Point3> ours = test::plain(mesh).points;
  std::vector<Point3> theirs;
  for (std::size_t i = 0; i < expected[0].samples().size(); ++i)
    theirs.push_back(
        {expected[0].samples()[i], expected[1].samples()[i], expected[2].samples()[i]});
  std::sort(ours.begin(), ours.end());
  std::sort(theirs.begin(), theirs.end());
  EXPECT_EQ(ours, theirs);
}

TEST(openmesh, float_points_are_double_results_rounded_once) {
  const Mesh terrain = test::terrain_mesh(4, 5);
  test::FloatMesh mesh;
  test::fill(mesh, terrain);
  GridSubdividerT<test::FloatMesh> subdivide("gentle");
  ASSERT_TRUE(subdivide(mesh, 3));
  test::FloatMesh in_float;
  test::fill(in_float, terrain);
  GridSubdividerT<test::FloatMesh, float> subdivide_float("gentle");
  ASSERT_TRUE(subdivide_float(in_float, 3));
  // The input is rounded to float before either.
  Mesh rounded = terrain;
  for (Point3& p : rounded.points)
    for (double& x : p) x = static_cast<float>(x);
  PolyMesh exact;
  test::fill(exact, rounded);
  GridSubdividerT<PolyMesh> subdivide_exact("gentle");
  ASSERT_TRUE(subdivide_exact(exact, 3));
  for (auto v : exact.vertices()) {
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(mesh.point(v)[k], static_cast<float>(exact.point(v)[k]));
      EXPECT_NEAR(in_float.point(v)[k], exact.point(v)[k], 1e-5);
    }
  }
}

TEST(openmesh, threads_do_not_change_a_bit) {
  const Mesh terrain = test::terrain_mesh(40, 50);
  PolyMesh one, many;
  test::fill(one, terrain);
  test::fill(many, terrain);
  GridSubdividerT<PolyMesh> subdivide("craggy");
  ASSERT_TRUE(subdivide(one, 3));
  subdivide.set_threads(4);
  ASSERT_TRUE(subdivide(many, 3));
  EXPECT_EQ(test::plain(one).points, test::plain(many).points);
  EXPECT_EQ(test::plain(one).faces.corners, test::plain(many).faces.corners);
  test::expect_sound(many);
}

TEST(openmesh, grids_of_every_small_size_come_out_sound) {
  for (Index rows = 2; rows <= 7; ++rows) {
    for (Index cols = 2; cols <= 7; ++cols) {
      std::vector<Mesh> meshes{test::terrain_mesh(rows, cols)};
      if (cols >= 3) meshes.push_back(test::tube_mesh(rows, cols));
      if (rows >= 3 && cols >= 3) meshes.push_back(test::torus_mesh(rows, cols));
      for (const Mesh& plain : meshes) {
        for (const bool turned : {false, true}) {
          PolyMesh mesh;
          test::fill(mesh, turned ? test::turned_over(plain) : plain);
          GridSubdividerT<PolyMesh> subdivide("four-point");
          ASSERT_TRUE(subdivide(mesh, 1));
          test::expect_sound(mesh);
          const Mesh fine = test::plain(mesh);
          EXPECT_EQ(test::oriented_patches(fine).size(), 1u) << rows << " x " << cols;
        }
      }
    }
  }
}

TEST(openmesh, edges_written_whole_are_those_the_setters_make) {
  ASSERT_TRUE(openmesh::detail::EdgeStore::direct_is_right())
      << "OpenMesh has another layout: refinement still works, but slower";
  PolyMesh whole;
  test::fill(whole, test::torus_mesh(4, 5));
  PolyMesh set = whole;
  openmesh::detail::EdgeStore direct(whole, true);
  openmesh::detail::EdgeStore setters(set, false);
  for (auto e : whole.edges()) {
    const auto fields = [&](unsigned i) {
      const auto h = whole.halfedge_handle(e, i);
      return openmesh::detail::HalfEdgeFields{
          whole.face_handle(h).idx(), whole.to_vertex_handle(h).idx(),
          whole.next_halfedge_handle(h).idx(), whole.prev_halfedge_handle(h).idx()};
    };
    direct.write(e.idx(), fields(0), fields(1));
    setters.write(e.idx(), fields(0), fields(1));
  }
  test::expect_sound(whole);
  test::expect_sound(set);
  EXPECT_EQ(test::plain(whole).faces.corners, test::plain(set).faces.corners);
}

TEST(openmesh, a_mesh_of_half_a_million_vertices_is_sound_and_right) {
  // Larger than one band of rows and than a large memory page.
  const Mesh terrain = test::terrain_mesh(36, 50);
  PolyMesh mesh;
  test::fill(mesh, terrain);
  GridSubdividerT<PolyMesh> subdivide("gentle");
  subdivide.set_threads(2);
  ASSERT_TRUE(subdivide(mesh, 4));
  EXPECT_EQ(mesh.n_vertices(), 561u * 785u);
  std::ostringstream complaints;
  EXPECT_TRUE(OpenMesh::Utils::MeshCheckerT<PolyMesh>(mesh).check(
      OpenMesh::Utils::MeshCheckerT<PolyMesh>::CHECK_ALL, complaints))
      << complaints.str();
  expect_planes(test::plain(mesh), by_engine(terrain, parse_scheme("gentle"), 4), "gentle");
}

TEST(openmesh, vertices_can_be_put_on_the_limit_surface) {
  // The limit at the same place does not depend on the level it is asked at.
  const Mesh terrain = test::terrain_mesh(6, 7);
  const Scheme scheme = parse_scheme("b-spline:degree=3");
  PolyMesh coarse, fine;
  test::fill(coarse, terrain);
  test::fill(fine, terrain);
  GridSubdividerT<PolyMesh> subdivide(scheme);
  subdivide.set_on_limit(true);
  ASSERT_TRUE(subdivide(coarse, 1));
  ASSERT_TRUE(subdivide(fine, 3));
  for (int v = 0; v < terrain.vertices(); ++v) {
    const PolyMesh::VertexHandle handle(v);
    EXPECT_LT((coarse.point(handle) - fine.point(handle)).norm(), 1e-13);
  }
  EXPECT_GT(
      (coarse.point(PolyMesh::VertexHandle(9)) - OpenMesh::Vec3d(terrain.points[9].data())).norm(),
      0.001);

  PolyMesh refused;
  test::fill(refused, terrain);
  GridSubdividerT<PolyMesh> divergent("mask:arity=2,first=-1,coefficients=2;1;-1;0");
  divergent.set_on_limit(true);
  const test::Complaints complaints;
  EXPECT_FALSE(divergent(refused, 1));
  EXPECT_NE(complaints.text().find("no certified limit"), std::string::npos) << complaints.text();
}

TEST(openmesh, strips_and_single_quads_are_grids_too) {
  for (const Extent extent : {Extent{2, 2}, Extent{2, 9}, Extent{6, 2}}) {
    PolyMesh mesh;
    test::fill(mesh, test::shuffled(test::terrain_mesh(extent.rows, extent.cols), 1));
    GridSubdividerT<PolyMesh> subdivide("craggy");
    ASSERT_TRUE(subdivide(mesh, 3));
    test::expect_sound(mesh);
    EXPECT_EQ(mesh.n_vertices(),
              static_cast<std::size_t>((8 * extent.rows - 7) * (8 * extent.cols - 7)));
  }
}

}  // namespace
}  // namespace arete
