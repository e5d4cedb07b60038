// SPDX-License-Identifier: MIT
// What is no grid is refused, and the message names the first vertex or face that offends.
#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "arete/topology/recover.h"
#include "topology/meshes.h"

namespace arete {
namespace {

using test::Mesh;

std::optional<NotAGrid> refusal(const Mesh& mesh) {
  try {
    (void)recover_grids(mesh.faces, mesh.vertices(), mesh.points);
  } catch (const NotAGrid& error) {
    return error;
  }
  return std::nullopt;
}

void expect_vertex(const Mesh& mesh, int vertex, const std::string& text) {
  const auto error = refusal(mesh);
  ASSERT_TRUE(error) << "not refused: " << text;
  EXPECT_EQ(error->vertex(), vertex) << error->what();
  EXPECT_EQ(error->face(), -1);
  EXPECT_NE(std::string(error->what()).find(text), std::string::npos) << error->what();
  EXPECT_EQ(std::string(error->what()).find("vertex " + std::to_string(vertex)), 0u);
}

void expect_face(const Mesh& mesh, int face, const std::string& text) {
  const auto error = refusal(mesh);
  ASSERT_TRUE(error) << "not refused: " << text;
  EXPECT_EQ(error->face(), face) << error->what();
  EXPECT_NE(std::string(error->what()).find(text), std::string::npos) << error->what();
}

Mesh with_face(Mesh mesh, const std::vector<int>& face) {
  mesh.faces.add(face);
  return mesh;
}

// Vertices r 5 + c, faces r 4 + c.
const Mesh grid = test::terrain_mesh(5, 5);

TEST(recover_grids, refuses_a_hole_by_its_first_vertex) {
  expect_vertex(test::without_faces(grid, {5}), 6, "a hole or a notch");
  Mesh triangles = test::triangulated(grid, [](int) { return true; });
  expect_vertex(test::without_faces(triangles, {10, 11}), 6, "second rim");
}

TEST(recover_grids, refuses_a_notch_and_an_l_shape) {
  expect_vertex(test::without_faces(grid, {2}), 7, "3 faces");
  expect_vertex(test::without_faces(grid, {2, 3, 6, 7}), 12, "3 faces");
  const Mesh triangles = test::triangulated(grid, [](int) { return true; });
  EXPECT_TRUE(refusal(test::without_faces(triangles, {4, 5})));
  EXPECT_TRUE(refusal(test::without_faces(triangles, {6, 7, 4, 5, 12, 13, 14, 15})));
  EXPECT_TRUE(refusal(test::without_faces(triangles, {13})));
}

TEST(recover_grids, refuses_an_extraordinary_vertex) {
  // A cube: closed, every vertex has three faces.
  Mesh cube;
  cube.points.resize(8);
  for (const std::vector<int>& face : std::vector<std::vector<int>>{
           {0, 1, 2, 3}, {7, 6, 5, 4}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}})
    cube.faces.add(face);
  expect_vertex(cube, 0, "an extraordinary vertex");
  // Three quads around a vertex.
  Mesh star;
  star.points.resize(7);
  for (const std::vector<int>& face :
       std::vector<std::vector<int>>{{6, 0, 1, 2}, {6, 2, 3, 4}, {6, 4, 5, 0}})
    star.faces.add(face);
  expect_vertex(star, 6, "has 3 faces");
}

TEST(recover_grids, refuses_edges_and_vertices_that_are_not_manifold) {
  expect_face(with_face(grid, {6, 5, 0, 1}), 16, "duplicate");
  Mesh fin = with_face(grid, {6, 7, 25, 26});
  fin.points.resize(27);
  expect_face(fin, 16, "more than two faces");
  Mesh bow_tie = with_face(grid, {24, 25, 26, 27});
  bow_tie.points.resize(28);
  expect_vertex(bow_tie, 24, "touch only there");
}

TEST(recover_grids, refuses_flipped_faces) {
  // Face 5 runs 6, 11, 12, 7.
  const Mesh others = test::without_faces(grid, {5});
  EXPECT_FALSE(refusal(with_face(others, {12, 7, 6, 11})));
  expect_face(with_face(others, {7, 12, 11, 6}), 15, "flipped");
}

TEST(recover_grids, refuses_garbage) {
  expect_face(with_face(grid, {1, 0, 12}), 16, "run from");
  expect_face(with_face(grid, {30, 31, 32, 33}), 16, "the file is damaged");
  expect_face(with_face(grid, {-1, 1, 2, 3}), 16, "vertex -1");
  expect_face(with_face(grid, {3, 4, 3, 4}), 16, "twice");
  expect_face(with_face(grid, {3}), 16, "has 1 corners");
  expect_face(with_face(grid, {0, 1, 2, 3, 4}), 16, "has 5 corners");
  expect_face(with_face(grid, {}), 16, "has 0 corners");
}

TEST(recover_grids, refuses_a_fan_before_searching_its_neighbours) {
  Mesh fan;
  fan.points.resize(100001);
  for (int i = 1; i < 100000; ++i) fan.faces.add(std::vector<int>{0, i, i + 1});
  expect_vertex(fan, 0, "99999 faces");
}

TEST(recover_grids, refuses_triangles_mixed_with_quads) {
  Mesh mesh = test::without_faces(grid, {15});
  mesh = with_face(with_face(mesh, {18, 23, 24}), {18, 24, 19});
  expect_face(mesh, 15, "all quads or all triangles");
}

TEST(recover_grids, refuses_a_torus_that_closes_with_an_offset) {
  // A row of 8 quads closed on itself with the rows shifted by 3.
  Mesh mesh;
  const int rows = 4, cols = 8;
  mesh.points.resize(rows * cols);
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < cols; ++c) {
      const auto v = [&](int i, int j) {
        return i % rows * cols + (j + (i == rows ? 3 : 0)) % cols;
      };
      mesh.faces.add(std::vector<int>{v(r, c), v(r, c + 1), v(r + 1, c + 1), v(r + 1, c)});
    }
  expect_face(mesh, 0, "close with an offset");
}

TEST(recover_grids, refuses_closed_surfaces_and_tubes_of_triangles) {
  const auto cut = [](const Mesh& mesh) {
    return test::triangulated(mesh, [](int) { return true; });
  };
  expect_face(cut(test::torus_mesh(5, 6)), 0, "closed surface");
  const auto error = refusal(cut(test::tube_mesh(4, 7)));
  ASSERT_TRUE(error);
  EXPECT_NE(std::string(error->what()).find("second rim"), std::string::npos);
}

TEST(recover_grids, refuses_a_moebius_strip) {
  Mesh mesh;
  mesh.points.resize(16);
  for (int c = 0; c < 8; ++c) {
    const auto v = [](int side, int i) { return i < 8 ? 2 * i + side : 1 - side; };
    mesh.faces.add(std::vector<int>{v(0, c), v(0, c + 1), v(1, c + 1), v(1, c)});
  }
  const auto error = refusal(mesh);
  ASSERT_TRUE(error);
  EXPECT_NE(std::string(error->what()).find("coherently"), std::string::npos);
}

}  // namespace
}  // namespace arete
