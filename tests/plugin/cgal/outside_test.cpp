// SPDX-License-Identifier: MIT
// What stands outside the hull of the points.
#include <gtest/gtest.h>

#include <cmath>

#include "clouds.h"

namespace arete {
namespace {

using cgal::GridMethod;
using cgal::OutsideHull;
using test::Cloud;

// A regular 24-gon of radius 10 with points inside, in a box of side 40.
Cloud disc(const test::Height& height) {
  Cloud cloud;
  for (int i = 0; i < 24; ++i) {
    const double a = i * 3.14159265358979 / 12;
    for (const double r : {3.0, 7.0, 10.0}) {
      const double x = r * std::cos(a + r);
      const double y = r * std::sin(a + r);
      cloud.add(x, y, height(x, y));
    }
  }
  return cloud;
}

const cgal::PlaneBox wide{-20, -20, 20, 20};

double plane(double x, double y) { return 5 + x - 3 * y; }

TEST(outside, is_nodata_unless_asked_for) {
  const auto grid =
      grid_points(disc(plane).points(), {.spacing = WorldPoint{0.5, 0.5}, .box = wide});
  for (Index r = 0; r < grid.heights.rows(); ++r)
    for (Index c = 0; c < grid.heights.cols(); ++c) {
      const WorldPoint p =
          grid.georeference.position(static_cast<double>(r), static_cast<double>(c));
      const double radius = std::hypot(p.x, p.y);
      const bool missing = std::isnan(grid.heights(r, c));
      EXPECT_TRUE(missing || radius < 10.001) << p.x << ", " << p.y;
      EXPECT_TRUE(!missing || radius > 9.9) << p.x << ", " << p.y;
    }
}

TEST(outside, a_plane_extrapolates_to_itself) {
  for (const GridMethod method : {GridMethod::natural_neighbour, GridMethod::linear}) {
    const auto grid = grid_points(disc(plane).points(), {.spacing = WorldPoint{0.5, 0.5},
                                                         .box = wide,
                                                         .method = method,
                                                         .outside = OutsideHull::extrapolate});
    EXPECT_EQ(grid.missing, 0);
    EXPECT_LE(test::largest_difference(grid, plane), 1e-10) << cgal::to_string(method);
  }
}

TEST(outside, nearest_is_the_height_of_the_nearest_place_of_the_hull) {
  // By brute force over all edges of the polygon, its vertices by their angle.
  Cloud rim;
  const Cloud cloud = disc(plane);
  for (std::size_t i = 2; i < cloud.x.size(); i += 3) rim.add(cloud.x[i], cloud.y[i], cloud.z[i]);
  const auto nearest = [&](double x, double y) {
    double best = 1e300;
    double height = 0;
    for (std::size_t i = 0; i < rim.x.size(); ++i) {
      const std::size_t j = (i + 1) % rim.x.size();
      const double dx = rim.x[j] - rim.x[i];
      const double dy = rim.y[j] - rim.y[i];
      const double t =
          std::clamp(((x - rim.x[i]) * dx + (y - rim.y[i]) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
      const double d = std::hypot(x - rim.x[i] - t * dx, y - rim.y[i] - t * dy);
      if (d < best) {
        best = d;
        height = rim.z[i] + t * (rim.z[j] - rim.z[i]);
      }
    }
    return height;
  };
  for (const GridMethod method : {GridMethod::natural_neighbour, GridMethod::linear}) {
    const auto grid = grid_points(cloud.points(), {.spacing = WorldPoint{0.5, 0.5},
                                                   .box = wide,
                                                   .method = method,
                                                   .outside = OutsideHull::nearest});
    EXPECT_LE(test::largest_difference(
                  grid, nearest, [](double x, double y) { return std::hypot(x, y) > 10.001; }),
              1e-10)
        << cgal::to_string(method);
  }
}

TEST(outside, the_surface_has_no_step_at_the_hull) {
  const auto bumpy = [](double x, double y) { return std::sin(x) * std::cos(y) + 0.1 * x * y; };
  for (const GridMethod method :
       {GridMethod::natural_neighbour, GridMethod::linear, GridMethod::inverse_distance})
    for (const OutsideHull outside : {OutsideHull::nearest, OutsideHull::extrapolate}) {
      const auto grid = grid_points(disc(bumpy).points(), {.spacing = WorldPoint{0.01, 0.01},
                                                           .box = cgal::PlaneBox{8, -1, 11, 1},
                                                           .method = method,
                                                           .outside = outside});
      double largest = 0;
      for (Index r = 0; r < grid.heights.rows(); ++r)
        for (Index c = 1; c < grid.heights.cols(); ++c)
          largest = std::max(largest, std::abs(grid.heights(r, c) - grid.heights(r, c - 1)));
      EXPECT_LT(largest, 0.05) << cgal::to_string(method) << ", " << cgal::to_string(outside);
    }
}

TEST(outside, points_on_a_line_have_no_hull_but_distances) {
  Cloud line;
  for (int i = 0; i <= 10; ++i) line.add(i, 2 * i, i);
  for (const GridMethod method : {GridMethod::natural_neighbour, GridMethod::linear})
    EXPECT_THROW((void)grid_points(line.points(), {.spacing = WorldPoint{1, 1}, .method = method}),
                 InvalidField);
  cgal::GridRequest request{.spacing = WorldPoint{1, 1}, .method = GridMethod::inverse_distance};
  EXPECT_THROW((void)grid_points(line.points(), request), InvalidField);
  request.outside = OutsideHull::nearest;
  const auto grid = grid_points(line.points(), request);
  EXPECT_EQ(grid.missing, 0);
  // The foot of (10, 0) on the line y = 2x is (2, 4).
  EXPECT_NEAR(grid.heights(20, 10), 2, 1e-12);
}

}  // namespace
}  // namespace arete
