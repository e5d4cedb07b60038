// SPDX-License-Identifier: GPL-3.0-or-later
#include "arete/meshlab/terrain_from_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "arete/meshlab/plan_grid.h"
#include "meshlab/grid_mesh.h"

namespace arete::meshlab {
namespace {

using test::grid_mesh;
using test::GridMesh;

double hill(double x, double y) {
  return 20 * std::exp(-((x - 50) * (x - 50) + (y - 40) * (y - 40)) / 900);
}
double plane(double x, double y) { return 7 + 0.5 * x - 0.25 * y; }

MeshArrays cloud(int count, double (*height)(double, double)) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> x(0, 100), y(0, 80);
  MeshArrays points;
  points.positions = {{0, 0, 0}, {100, 0, 0}, {0, 80, 0}, {100, 80, 0}};
  for (int i = 0; i < count; ++i) points.positions.push_back({x(random), y(random), 0});
  for (Point3& p : points.positions) p[2] = height(p[0], p[1]);
  return points;
}

CreatedMesh run(const MeshArrays& mesh, const FromPointsOptions& options) {
  Report report;
  return terrain_from_points(mesh, options, report);
}

FromPointsOptions by(std::optional<cgal::GridMethod> method, double spacing) {
  FromPointsOptions options;
  options.method = method;
  options.spacing = spacing;
  return options;
}

TEST(plan_grid, nodes_lie_in_the_middle_of_the_box) {
  const std::vector<Point3> corners{{10, 20, 0}, {20, 27, 0}, {std::nan(""), 1e9, 0}};
  const PlanGrid grid = plan_grid(corners, 2);
  EXPECT_EQ(grid.extent, (Extent{4, 6}));
  EXPECT_EQ(grid.x(0), 10);
  EXPECT_EQ(grid.x(5), 20);
  EXPECT_EQ(grid.y(0), 26.5);
  EXPECT_EQ(grid.y(3), 20.5);
  // A tenth cannot be written exactly, and still both ends are nodes.
  EXPECT_EQ(plan_grid({{0, 0, 0}, {0.7, 0.3, 0}}, 0.1).extent, (Extent{4, 8}));
}

TEST(terrain_from_points, a_plane_stays_a_plane_by_every_method) {
  const MeshArrays points = cloud(400, plane);
  for (auto method : {cgal::GridMethod::natural_neighbour, cgal::GridMethod::linear}) {
    const CreatedMesh made = run(points, by(method, 5));
    ASSERT_EQ(made.arrays.positions.size(), 21u * 17u);
    for (const Point3& p : made.arrays.positions)
      EXPECT_NEAR(p[2], plane(p[0], p[1]), 1e-9) << int(method);
  }
}

TEST(terrain_from_points, a_hill_is_met_between_the_points) {
  const CreatedMesh made = run(cloud(3000, hill), by(cgal::GridMethod::natural_neighbour, 4));
  // Not at the rim, where the hull spans from corner to corner.
  double largest = 0;
  for (const Point3& p : made.arrays.positions)
    if (p[0] > 2 && p[0] < 98 && p[1] > 2 && p[1] < 78)
      largest = std::max(largest, std::abs(p[2] - hill(p[0], p[1])));
  EXPECT_LT(largest, 0.03);  // linear on the triangles is off by 0.08
}

TEST(terrain_from_points, the_grid_is_quads_that_look_up_and_can_be_subdivided) {
  const CreatedMesh made = run(cloud(50, hill), by(cgal::GridMethod::linear, 10));
  const MeshArrays& arrays = made.arrays;
  ASSERT_EQ(arrays.positions.size(), 11u * 9u);
  EXPECT_EQ(arrays.triangles.size(), 2u * 10u * 8u);
  EXPECT_TRUE(made.source_triangles.empty());
  std::map<std::pair<int, int>, int> inner;
  double area = 0;
  for (std::size_t f = 0; f < arrays.triangles.size(); ++f) {
    const Triangle& t = arrays.triangles[f];
    const double part = test::area_from_above(arrays.positions, t);
    EXPECT_GT(part, 0);
    area += part;
    for (std::size_t k = 0; k < 3; ++k)
      if ((arrays.inner_edges[f] >> k) & 1) ++inner[std::minmax(t[k], t[(k + 1) % 3])];
  }
  EXPECT_NEAR(area, 8000, 1e-6);
  EXPECT_EQ(inner.size(), 80u);
  for (const auto& [edge, count] : inner) EXPECT_EQ(count, 2);
}

TEST(terrain_from_points, own_triangles_give_the_surface_of_the_mesh) {
  // Any diagonals: the heights between the vertices depend on them.
  const GridMesh mesh = grid_mesh({4, 5}, {test::MeshForm::Diagonals::random, false, true});
  const CreatedMesh made = run(mesh.arrays, by(std::nullopt, 5));
  ASSERT_EQ(made.arrays.positions.size(), 9u * 13u);
  for (const Point3& p : made.arrays.positions) {
    double expected = std::nan("");
    for (const Triangle& t : mesh.arrays.triangles) {
      std::vector<Point3> points = mesh.arrays.positions;
      points.push_back(p);
      const int m = int(points.size()) - 1;
      const double whole = test::area_from_above(points, t);
      const double a = test::area_from_above(points, {m, t[1], t[2]}) / whole;
      const double b = test::area_from_above(points, {t[0], m, t[2]}) / whole;
      const double c = test::area_from_above(points, {t[0], t[1], m}) / whole;
      if (a < -1e-9 || b < -1e-9 || c < -1e-9) continue;
      expected = a * points[std::size_t(t[0])][2] + b * points[std::size_t(t[1])][2] +
                 c * points[std::size_t(t[2])][2];
    }
    EXPECT_NEAR(p[2], expected, 1e-6);
  }
}

TEST(terrain_from_points, where_own_triangles_overlap_the_highest_counts) {
  MeshArrays mesh;
  for (double z : {1.0, 5.0, 3.0}) {
    const int n = int(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {{0, 0, z}, {10, 0, z}, {10, 10, z}, {0, 10, z}});
    mesh.triangles.push_back({n, n + 1, n + 2});
    mesh.triangles.push_back({n, n + 2, n + 3});
  }
  for (const Point3& p : run(mesh, by(std::nullopt, 2)).arrays.positions) EXPECT_EQ(p[2], 5);
}

TEST(terrain_from_points, holes_of_a_tin_are_bridged_or_left_out) {
  GridMesh mesh = grid_mesh({6, 6}, {}, [](Index r, Index c) { return double(3 * r - c); });
  auto& triangles = mesh.arrays.triangles;
  triangles.erase(triangles.begin() + 24, triangles.begin() + 26);  // cell (2, 2)
  FromPointsOptions options = by(std::nullopt, 5);
  const CreatedMesh bridged = run(mesh.arrays, options);
  ASSERT_EQ(bridged.arrays.positions.size(), 21u * 11u);
  for (const Point3& p : bridged.arrays.positions)
    EXPECT_NEAR(p[2], 3 * (5 - p[1] / 20) - p[0] / 10, 1e-9);
  options.outside = cgal::OutsideHull::nodata;
  const CreatedMesh open = run(mesh.arrays, options);
  EXPECT_EQ(open.arrays.positions.size(), 21u * 11u - 3u);  // strictly inside the hole: 1 x 3
  EXPECT_EQ(open.arrays.triangles.size(), 2u * (20u * 10u - 8u));
  for (const Triangle& t : open.arrays.triangles)
    for (int v : t) EXPECT_LT(std::size_t(v), open.arrays.positions.size());
}

TEST(terrain_from_points, colour_and_quality_come_along) {
  MeshArrays points = cloud(500, hill);
  Channel linear{{}, Blend::within}, constant{{}, Blend::within}, texture{{}, Blend::nearest};
  for (const Point3& p : points.positions) {
    linear.values.push_back(float(2 * p[0] + p[1]));
    constant.values.push_back(255);
    texture.values.push_back(3);
  }
  points.channels = {linear, constant, texture};
  const MeshArrays made = run(points, by(cgal::GridMethod::natural_neighbour, 10)).arrays;
  ASSERT_EQ(made.channels.size(), 3u);
  for (std::size_t v = 0; v < made.positions.size(); ++v) {
    EXPECT_NEAR(made.channels[0].values[v], 2 * made.positions[v][0] + made.positions[v][1], 1e-3);
    EXPECT_EQ(made.channels[1].values[v], 255);
    EXPECT_EQ(made.channels[2].values[v], 3);
  }
}

TEST(terrain_from_points, bad_points_are_passed_over_and_told) {
  MeshArrays points = cloud(300, plane);
  points.positions[7][2] = std::nan("");
  points.positions[9][0] = HUGE_VAL;
  Report report;
  const CreatedMesh made = terrain_from_points(points, by(cgal::GridMethod::linear, 10), report);
  for (const Point3& p : made.arrays.positions) EXPECT_NEAR(p[2], plane(p[0], p[1]), 1e-9);
  std::string log;
  for (const std::string& line : report.lines()) log += line + "\n";
  EXPECT_NE(log.find("2 points with a coordinate that is not a finite number"), std::string::npos)
      << log;
}

TEST(terrain_from_points, an_outlier_is_dropped_on_request) {
  MeshArrays points = cloud(600, hill);
  points.positions.push_back({30, 30, 5000});
  FromPointsOptions options = by(cgal::GridMethod::linear, 5);
  const auto highest = [&] {
    double z = -1e9;
    for (const Point3& p : run(points, options).arrays.positions) z = std::max(z, p[2]);
    return z;
  };
  EXPECT_GT(highest(), 100);
  options.drop_outliers = 8;
  EXPECT_LT(highest(), 21);
}

TEST(terrain_from_points, what_makes_no_terrain_is_refused_with_the_reason) {
  const auto refusal = [](const MeshArrays& mesh, const FromPointsOptions& options) {
    try {
      (void)run(mesh, options);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("not refused");
  };
  const auto says = [](const std::string& text, const char* part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  const auto linear = by(cgal::GridMethod::linear, 5);
  says(refusal({}, linear), "empty");
  MeshArrays line;
  for (int i = 0; i < 9; ++i) line.positions.push_back({double(i), 0, 1});
  says(refusal(line, linear), "on one line");
  for (Point3& p : line.positions) p[1] = 2 * p[0];
  says(refusal(line, by(cgal::GridMethod::linear, 1)), "line");
  MeshArrays nothing;
  nothing.positions.assign(5, {std::nan(""), 0, 0});
  says(refusal(nothing, linear), "finite");
  const MeshArrays points = cloud(50, hill);
  says(refusal(points, by(cgal::GridMethod::linear, 81)), "choose at most 80");
  says(refusal(points, by(cgal::GridMethod::linear, 1e-6)), "larger");
  says(refusal(points, by(std::nullopt, 5)), "no triangles");
}

}  // namespace
}  // namespace arete::meshlab
