// SPDX-License-Identifier: MIT
// Laws of gridding scattered points inside their hull.
#include "arete/cgal/scattered_grid.h"

#include <gtest/gtest.h>

#include <cmath>

#include "clouds.h"

namespace arete {
namespace {

using cgal::GridMethod;
using cgal::GridRequest;
using test::Cloud;

double plane(double x, double y) { return 40 + 3 * x - 2 * y; }
double spherical(double x, double y) { return 7 - 2 * x + y + 0.05 * (x * x + y * y); }
double hills(double x, double y) { return 20 * std::sin(x / 15) * std::cos(y / 11); }

TEST(grid_points, planes_are_reproduced) {
  const Cloud cloud = test::random_cloud(300, plane);
  for (const GridMethod method : {GridMethod::natural_neighbour, GridMethod::linear}) {
    const auto grid =
        grid_points(cloud.points(), {.spacing = WorldPoint{0.7, 0.9}, .method = method});
    EXPECT_EQ(grid.missing, 0);
    EXPECT_LE(test::largest_difference(grid, plane), 1e-10) << cgal::to_string(method);
    EXPECT_LE(grid.largest_error, 1e-10);
  }
}

TEST(grid_points, planes_are_reproduced_between_the_slivers_along_the_hull) {
  // A hull with a bulge of 1e-7: circles through its slivers have radii of 1e9.
  Cloud cloud = test::random_cloud(300, plane);
  for (int i = 1; i < 40; ++i) {
    const double t = 2.5 * i;
    cloud.add(t, -1e-7 * t * (100 - t) / 2500, 0);
    cloud.z.back() = plane(cloud.x.back(), cloud.y.back());
  }
  const auto grid = grid_points(cloud.points(), {.spacing = WorldPoint{0.37, 0.25}});
  EXPECT_LE(test::largest_difference(grid, plane), 1e-10);
}

TEST(grid_points, natural_neighbour_reproduces_spherical_quadratics) {
  const Cloud cloud = test::random_cloud(400, spherical);
  const auto grid = grid_points(cloud.points(), {.spacing = WorldPoint{1.1, 1.3}});
  EXPECT_EQ(grid.missing, 0);
  EXPECT_LE(test::largest_difference(grid, spherical), 1e-8);
}

TEST(grid_points, heights_at_the_points_are_theirs) {
  // Every point is a sample of the grid.
  Cloud cloud;
  std::mt19937 random(3);
  for (int i = 0; i < 200; ++i)
    cloud.add(static_cast<double>(random() % 40), static_cast<double>(random() % 30),
              static_cast<double>(random() % 1000));
  for (const double x : {0.0, 39.0})
    for (const double y : {0.0, 29.0}) cloud.add(x, y, 5);
  for (const GridMethod method :
       {GridMethod::natural_neighbour, GridMethod::linear, GridMethod::inverse_distance}) {
    const auto grid = grid_points(cloud.points(), {.spacing = WorldPoint{1, 1}, .method = method});
    EXPECT_EQ(grid.heights.extent(), (Extent{30, 40}));
    EXPECT_EQ(grid.covered, grid.used);
    EXPECT_LE(grid.largest_error, 1e-9) << cgal::to_string(method);
    EXPECT_EQ(grid.used + grid.merged, 204);
  }
}

TEST(grid_points, natural_neighbour_has_tangents_at_the_points_where_linear_has_corners) {
  const Cloud cloud = test::random_cloud(150, hills);
  // By how much the slopes on both sides of a point differ.
  const auto corner = [&](GridMethod method, std::size_t i) {
    constexpr double e = 1e-4;
    const auto grid = grid_points(
        cloud.points(),
        {.size = Extent{3, 3},
         .box = cgal::PlaneBox{cloud.x[i] - e, cloud.y[i] - e, cloud.x[i] + e, cloud.y[i] + e},
         .method = method});
    const Grid<double>& z = grid.heights;
    return std::max(std::abs(z(1, 0) - 2 * z(1, 1) + z(1, 2)),
                    std::abs(z(0, 1) - 2 * z(1, 1) + z(2, 1))) /
           e;
  };
  double smooth = 0;
  double edged = 0;
  for (std::size_t i = 4; i < 24; ++i) {
    smooth = std::max(smooth, corner(GridMethod::natural_neighbour, i));
    edged = std::max(edged, corner(GridMethod::linear, i));
  }
  EXPECT_LT(smooth, 0.01);
  EXPECT_GT(edged, 0.5);
}

TEST(grid_points, linear_never_leaves_the_range_of_the_points) {
  const Cloud cloud = test::random_cloud(150, hills);
  const auto [low, high] = std::minmax_element(cloud.z.begin(), cloud.z.end());
  GridRequest request{.spacing = WorldPoint{0.5, 0.5}, .method = GridMethod::linear};
  const auto linear = grid_points(cloud.points(), request);
  for (const double z : linear.heights.samples()) {
    EXPECT_GE(z, *low - 1e-12);
    EXPECT_LE(z, *high + 1e-12);
  }
  request.method = GridMethod::natural_neighbour;
  EXPECT_LT(test::largest_difference(grid_points(cloud.points(), request), hills),
            test::largest_difference(linear, hills));
}

TEST(grid_points, inverse_distance_is_shepards_formula) {
  const Cloud cloud = test::random_cloud(8, hills, 10);
  const auto grid = grid_points(
      cloud.points(),
      {.size = Extent{7, 5}, .method = GridMethod::inverse_distance, .neighbours = 12, .power = 3});
  // All twelve points count, so that the formula can be written down as it is printed.
  const auto shepard = [&](double x, double y) {
    double sum = 0;
    double weights = 0;
    for (std::size_t i = 0; i < cloud.x.size(); ++i) {
      const double d = std::hypot(x - cloud.x[i], y - cloud.y[i]);
      if (d == 0) return cloud.z[i];
      sum += cloud.z[i] / (d * d * d);
      weights += 1 / (d * d * d);
    }
    return sum / weights;
  };
  EXPECT_LE(test::largest_difference(grid, shepard), 1e-11);
}

TEST(grid_points, large_offsets_cost_no_digits) {
  const Cloud near = test::random_cloud(300, hills);
  Cloud far = near;
  for (double& x : far.x) x += 500000;
  for (double& y : far.y) y += 4649776.25;
  for (const GridMethod method : {GridMethod::natural_neighbour, GridMethod::linear}) {
    const GridRequest request{.spacing = WorldPoint{0.5, 0.5}, .method = method};
    const auto a = grid_points(near.points(), request);
    const auto b = grid_points(far.points(), request);
    ASSERT_EQ(a.heights.extent(), b.heights.extent());
    for (std::size_t i = 0; i < a.heights.samples().size(); ++i)
      // The offsets round the coordinates themselves to 1e-9.
      ASSERT_NEAR(a.heights.samples()[i], b.heights.samples()[i], 1e-7);
  }
  // Coordinates that the offset does not round at all: the same bits.
  Cloud whole;
  for (std::size_t i = 0; i < near.x.size(); ++i)
    whole.add(std::round(near.x[i] * 8) / 8, std::round(near.y[i] * 8) / 8, near.z[i]);
  Cloud whole_far = whole;
  for (double& x : whole_far.x) x += 500000;
  for (double& y : whole_far.y) y += 4649776.25;
  const GridRequest request{.spacing = WorldPoint{0.5, 0.5}};
  EXPECT_EQ(grid_points(whole.points(), request).heights.samples(),
            grid_points(whole_far.points(), request).heights.samples());
}

TEST(grid_points, the_order_of_points_and_the_threads_do_not_change_a_bit) {
  Cloud cloud = test::random_cloud(500, hills);
  for (int i = 0; i < 50; ++i) cloud.add(cloud.x[9], cloud.y[9], i);
  Cloud shuffled;
  std::vector<std::size_t> order(cloud.x.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::shuffle(order.begin(), order.end(), std::mt19937(1));
  for (const std::size_t i : order) shuffled.add(cloud.x[i], cloud.y[i], cloud.z[i]);
  for (const GridMethod method :
       {GridMethod::natural_neighbour, GridMethod::linear, GridMethod::inverse_distance}) {
    GridRequest request{.spacing = WorldPoint{1, 1}, .method = method, .threads = 1};
    const auto once = grid_points(cloud.points(), request);
    request.threads = 5;
    EXPECT_EQ(once.heights.samples(), grid_points(cloud.points(), request).heights.samples());
    EXPECT_EQ(once.heights.samples(), grid_points(shuffled.points(), request).heights.samples());
  }
}

TEST(grid_points, samples_lie_where_the_georeference_says) {
  const Cloud cloud = test::random_cloud(
      100, [](double x, double) { return x; }, 60, 30, -20);
  const auto sized = grid_points(cloud.points(), {.size = Extent{13, 7}});
  EXPECT_EQ(sized.georeference.position(0, 0).x, 30);
  EXPECT_EQ(sized.georeference.position(0, 0).y, 40);
  EXPECT_EQ(sized.georeference.position(12, 6).x, 90);
  EXPECT_EQ(sized.georeference.position(12, 6).y, -20);
  EXPECT_EQ(sized.georeference.registration, Registration::point);
  EXPECT_NEAR(sized.heights(3, 2), 50, 1e-10);
  const auto boxed = grid_points(
      cloud.points(), {.spacing = WorldPoint{5, 2}, .box = cgal::PlaneBox{40, 0, 61, 10}});
  EXPECT_EQ(boxed.heights.extent(), (Extent{6, 5}));
  EXPECT_EQ(boxed.georeference.position(5, 4).x, 60);
  EXPECT_EQ(boxed.georeference.position(5, 4).y, 0);
  EXPECT_NEAR(boxed.heights(0, 4), 60, 1e-10);
}

}  // namespace
}  // namespace arete
