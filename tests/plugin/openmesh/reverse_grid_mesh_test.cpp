// SPDX-License-Identifier: MIT
// Meshes that are regular grids, taken apart by schemes of the catalogue.
#include <gtest/gtest.h>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <numeric>
#include <random>

#include "arete/openmesh/grid_subdivider.h"
#include "arete/openmesh/reverse_mesh.h"
#include "arete/openmesh/reverse_subdivider.h"
#include "arete/topology/grid_faces.h"
#include "reverse/meshes.h"
#include "support/schemes.h"

namespace arete {
namespace {

using openmesh::MeshData;

struct Shape {
  Extent extent;
  bool wraps_rows = false;
  bool wraps_cols = false;
  bool mirrored = false;
};

// A grid that lies as `refine` turns it, with noise in all coordinates.
MeshData grid_mesh(const Shape& shape, unsigned seed) {
  const auto [rows, cols] = shape.extent;
  const Grid<double> noise = test::random_positions(rows * cols, seed);
  MeshData mesh;
  for (Index r = 0; r < rows; ++r)
    for (Index c = 0; c < cols; ++c) {
      const Index v = r * cols + c;
      mesh.points.push_back({static_cast<double>(c) + noise(v, 0) / 8,
                             -static_cast<double>(r) + noise(v, 1) / 8, noise(v, 2)});
    }
  mesh.faces = grid_faces(shape.extent, shape.mirrored, shape.wraps_rows, shape.wraps_cols);
  return mesh;
}

// Vertices, faces and first corners in any order, and something attached.
MeshData shuffled(const MeshData& mesh, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<int> place(mesh.points.size());
  std::iota(place.begin(), place.end(), 0);
  std::shuffle(place.begin(), place.end(), random);
  MeshData result;
  result.points.resize(place.size());
  for (std::size_t v = 0; v < place.size(); ++v) {
    result.points[static_cast<std::size_t>(place[v])] = mesh.points[v];
    result.colors.push_back({static_cast<std::uint8_t>(random()), 0, 7, 255});
  }
  std::vector<int> faces(static_cast<std::size_t>(mesh.faces.count()));
  std::iota(faces.begin(), faces.end(), 0);
  std::shuffle(faces.begin(), faces.end(), random);
  for (const int f : faces) {
    std::vector<int> corners(mesh.faces[f].begin(), mesh.faces[f].end());
    for (int& v : corners) v = place[static_cast<std::size_t>(v)];
    std::rotate(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(random() % 4),
                corners.end());
    result.faces.add(corners);
    for (int k = 0; k < 4; ++k)
      result.corner_texcoords.push_back({static_cast<float>(random() % 1000), 0.25F});
  }
  return result;
}

openmesh::MeshCoarsenOptions options_of(const Scheme& scheme, ReverseMode mode, int levels) {
  openmesh::MeshCoarsenOptions options;
  options.grid_scheme = scheme;
  options.mode = mode;
  options.levels = levels;
  return options;
}

bool has_local(const Scheme& scheme) {
  return local_rule(scheme.mask()) != LocalRule::none && scheme.name() != "two-parameter";
}

constexpr ReverseMode modes[] = {ReverseMode::local, ReverseMode::least_squares};
const Shape shapes[] = {{{23, 18}},
                        {{18, 23}, false, false, true},
                        {{19, 16}, false, true},
                        {{21, 20}, true, true, true}};

TEST(reverse_grid_mesh, every_scheme_gives_every_bit_back_through_the_bytes_of_a_file) {
  for (const Scheme& scheme : test::sample_schemes())
    for (const ReverseMode mode : modes) {
      if (mode == ReverseMode::local && !has_local(scheme)) continue;
      for (const Shape& shape : shapes) {
        // A closed axis of three vertices is the shortest.
        if (std::min(shape.extent.rows, shape.extent.cols) < 3 * scheme.mask().arity()) continue;
        const MeshData mesh = shuffled(grid_mesh(shape, 3), 4);
        const int levels = scheme.mask().arity() == 2 ? 2 : 1;
        const auto done = openmesh::coarsen_mesh(mesh, options_of(scheme, mode, levels));
        EXPECT_LT(done.coarse.points.size(), mesh.points.size() / 2);
        EXPECT_EQ(done.coarse.colors.size(), done.coarse.points.size());
        EXPECT_EQ(done.coarse.corner_texcoords.size(), done.coarse.faces.corners.size());
        const MeshDetailsFile again = decode_mesh_details(encode_mesh_details(done.details));
        EXPECT_EQ(again.scheme_text(), scheme.text());
        const MeshData back = openmesh::restore_mesh(done.coarse, again, levels);
        EXPECT_EQ(back.points, mesh.points) << scheme.text() << ' ' << to_string(mode);
        EXPECT_EQ(back.faces.corners, mesh.faces.corners);
        EXPECT_EQ(back.colors, mesh.colors);
        EXPECT_EQ(back.corner_texcoords, mesh.corner_texcoords);
      }
    }
}

TEST(reverse_grid_mesh, what_refine_made_becomes_its_control_mesh) {
  for (const Scheme& scheme : test::sample_schemes())
    for (const ReverseMode mode : modes) {
      if (mode == ReverseMode::local && !has_local(scheme)) continue;
      if (scheme.name() == "difference" ||
          scheme.text().starts_with("three-parameter:a=1/5,c=-1/3"))
        continue;  // amplifies rounding by more than is asked for here
      const MeshData control = grid_mesh({{7, 9}}, 5);
      openmesh::MeshRefineOptions refine;
      refine.levels = 1;
      const MeshData fine = shuffled(openmesh::refine_mesh(control, scheme, scheme, refine), 6);
      const auto done = openmesh::coarsen_mesh(fine, options_of(scheme, mode, 1));
      ASSERT_EQ(done.coarse.points.size(), control.points.size()) << scheme.text();
      for (std::size_t v = 0; v < control.points.size(); ++v)
        for (std::size_t k = 0; k < 3; ++k)
          EXPECT_NEAR(done.coarse.points[v][k], control.points[v][k], 1e-10)
              << scheme.text() << ' ' << to_string(mode) << ' ' << v;
      EXPECT_LE(done.largest_detail, 1e-10) << scheme.text();
    }
}

TEST(reverse_grid_mesh, a_closed_or_cubic_grid_refined_several_times_becomes_its_control_mesh) {
  for (const Shape& shape : {Shape{{6, 7}}, Shape{{5, 6}, true, true}}) {
    const Scheme scheme = parse_scheme("b-spline:degree=3");
    const MeshData control = grid_mesh(shape, 8);
    openmesh::MeshRefineOptions refine;
    refine.levels = 3;
    const MeshData fine = openmesh::refine_mesh(control, scheme, scheme, refine);
    const auto done =
        openmesh::coarsen_mesh(fine, options_of(scheme, ReverseMode::least_squares, 3));
    EXPECT_EQ(done.coarse.points.size(), control.points.size());
    EXPECT_LE(done.largest_detail, 1e-10);
  }
}

TEST(reverse_grid_mesh, attributes_are_those_of_the_nearest_vertex) {
  const MeshData mesh = shuffled(grid_mesh({{9, 9}}, 1), 2);
  const auto done =
      openmesh::coarsen_mesh(mesh, options_of(parse_scheme("four-point"), ReverseMode::local, 1));
  ASSERT_EQ(done.coarse.points.size(), 25U);
  // An interpolatory scheme keeps every other vertex where it is.
  for (std::size_t v = 0; v < done.coarse.points.size(); ++v) {
    const auto place = static_cast<std::size_t>(done.details.levels[0].place[v]);
    EXPECT_EQ(done.coarse.points[v], mesh.points[place]);
    EXPECT_EQ(done.coarse.colors[v], mesh.colors[place]);
  }
}

std::string reason_for(const MeshData& mesh, Boundaries boundaries = {}, int levels = 1) {
  auto options = options_of(parse_scheme("chaikin"), ReverseMode::least_squares, levels);
  options.boundaries = boundaries;
  try {
    (void)openmesh::coarsen_mesh(mesh, options);
  } catch (const InvalidField& error) {
    return error.what();
  }
  return {};
}

TEST(reverse_grid_mesh, other_meshes_are_refused_with_the_reason) {
  MeshData triangles = grid_mesh({{6, 6}}, 1);
  FaceList cut;
  for (int f = 0; f < triangles.faces.count(); ++f) {
    const auto q = triangles.faces[f];
    cut.add(std::vector<int>{q[0], q[1], q[2]});
    cut.add(std::vector<int>{q[0], q[2], q[3]});
  }
  triangles.faces = cut;
  EXPECT_NE(reason_for(triangles).find("cut into triangles"), std::string::npos);

  MeshData holed = grid_mesh({{6, 6}}, 1);
  FaceList some;
  for (int f = 0; f < holed.faces.count(); ++f)
    if (f != 12) some.add(holed.faces[f]);
  holed.faces = some;
  EXPECT_NE(reason_for(holed).find("one regular grid of quads"), std::string::npos);

  MeshData two = grid_mesh({{4, 4}}, 1);
  two.points.insert(two.points.end(), two.points.begin(), two.points.end());
  for (int f = 0; f < 9; ++f) {
    std::vector<int> moved(two.faces[f].begin(), two.faces[f].end());
    for (int& v : moved) v += 16;
    two.faces.add(moved);
  }
  EXPECT_NE(reason_for(two).find("2 connected parts"), std::string::npos);

  const MeshData good = grid_mesh({{6, 6}}, 1);
  EXPECT_EQ(reason_for(good), "");
  MeshData loose = good;
  loose.points.push_back({9, 9, 9});
  EXPECT_NE(reason_for(loose).find("in no face"), std::string::npos);
  EXPECT_NE(reason_for(good, {Boundary::periodic, Boundary::clamp}).find("two ends"),
            std::string::npos);
  EXPECT_NE(reason_for(good, {}, 9).find("of 9 levels can be undone"), std::string::npos);
}

TEST(reverse_grid_mesh, a_details_file_whose_grid_does_not_fit_is_refused) {
  const auto done = openmesh::coarsen_mesh(
      grid_mesh({{9, 9}}, 1), options_of(parse_scheme("chaikin"), ReverseMode::local, 2));
  for (const Extent wrong : {Extent{9, 10}, {10, 9}, {1000000000, 1000000000}}) {
    MeshDetailsFile file = done.details;
    file.grid->fine = wrong;
    EXPECT_THROW((void)decode_mesh_details(encode_mesh_details(file)), InvalidDetails);
  }
}

TEST(reverse_grid_mesh, the_subdivider_goes_back_where_the_grid_subdivider_came_from) {
  struct Traits : public OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
  };
  using Mesh = OpenMesh::PolyMesh_ArrayKernelT<Traits>;
  const MeshData control = grid_mesh({{6, 8}}, 3);
  Mesh mesh;
  for (const Point3& p : control.points) mesh.add_vertex({p[0], p[1], p[2]});
  for (int f = 0; f < control.faces.count(); ++f) {
    std::vector<Mesh::VertexHandle> corners;
    for (const int v : control.faces[f]) corners.emplace_back(v);
    mesh.add_face(corners);
  }
  const Scheme scheme = parse_scheme("four-point");
  openmesh::GridSubdividerT<Mesh> subdivide;
  subdivide.set_schemes(scheme, scheme);
  subdivide.refine_or_throw(mesh, 1);
  const Mesh fine = mesh;
  openmesh::ReverseSubdividerT<Mesh> reverse(scheme);
  ASSERT_TRUE(reverse(mesh, 1));
  ASSERT_EQ(mesh.n_vertices(), control.points.size());
  for (auto v : mesh.vertices())
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(mesh.point(v)[k], control.points[static_cast<std::size_t>(v.idx())][k], 1e-10);
  ASSERT_TRUE(reverse.restore(mesh));
  ASSERT_EQ(mesh.n_faces(), fine.n_faces());
  for (auto v : mesh.vertices()) EXPECT_EQ(mesh.point(v), fine.point(v));
}

}  // namespace
}  // namespace arete
