// SPDX-License-Identifier: MIT
// Points of every bad kind: a clear refusal or a counted omission, never a crash.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "clouds.h"

namespace arete {
namespace {

using cgal::GridMethod;
using cgal::GridRequest;
using test::Cloud;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

void expect_refusal(const Cloud& cloud, const GridRequest& request, const std::string& part) {
  try {
    (void)grid_points(cloud.points(), request);
    ADD_FAILURE() << "not refused: " << part;
  } catch (const InvalidField& error) {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

double hills(double x, double y) { return 20 * std::sin(x / 15) * std::cos(y / 11); }

TEST(bad_points, too_few_are_refused) {
  const GridRequest unit{.spacing = WorldPoint{1, 1}};
  Cloud cloud;
  expect_refusal(cloud, unit, "no points");
  cloud.add(0, 0, 1);
  expect_refusal(cloud, unit, "one place");
  cloud.add(4, 3, 1);
  expect_refusal(cloud, unit, "one line");
  cloud.add(4, 3, 9);
  expect_refusal(cloud, unit, "one line");
  cloud.add(0, 3, 1);
  EXPECT_EQ(grid_points(cloud.points(), unit).used, 3);
}

TEST(bad_points, arrays_of_different_lengths_are_refused) {
  Cloud cloud = test::random_cloud(10, hills);
  cloud.z.pop_back();
  expect_refusal(cloud, {.spacing = WorldPoint{1, 1}}, "equally many");
}

TEST(bad_points, numbers_that_are_not_finite_are_counted_and_have_no_influence) {
  const Cloud clean = test::random_cloud(100, hills);
  Cloud cloud = clean;
  cloud.add(50, 50, nan);
  cloud.add(nan, 50, 1);
  cloud.add(50, -infinity, 1);
  const GridRequest request{.spacing = WorldPoint{2, 2}};
  const auto grid = grid_points(cloud.points(), request);
  EXPECT_EQ(grid.not_finite, 3);
  EXPECT_EQ(grid.heights.samples(), grid_points(clean.points(), request).heights.samples());
  Cloud none;
  none.add(nan, 1, 1);
  expect_refusal(none, request, "none of the 1 points");
}

TEST(bad_points, a_million_duplicates_are_one_point) {
  Cloud cloud = test::random_cloud(20, hills);
  for (int i = 0; i < 1000000; ++i) cloud.add(50, 50, i % 2 == 0 ? 3 : 5);
  const auto grid = grid_points(cloud.points(), {.spacing = WorldPoint{10, 10}});
  EXPECT_EQ(grid.merged, 999999);
  EXPECT_EQ(grid.used, 25);
  EXPECT_NEAR(grid.heights(5, 5), 4, 1e-9);
  Cloud all_equal;
  for (int i = 0; i < 1000; ++i) all_equal.add(1, 1, 1);
  expect_refusal(all_equal, {.spacing = WorldPoint{1, 1}}, "one place");
}

TEST(bad_points, gross_errors_are_dropped_when_asked) {
  const Cloud clean = test::random_cloud(2000, hills);
  Cloud cloud = clean;
  for (int i = 0; i < 10; ++i) cloud.add(7.3 + 9 * i, 91.7 - 8 * i, i % 2 == 0 ? 9999 : -9999);
  GridRequest request{.spacing = WorldPoint{1, 1}};
  EXPECT_GT(test::largest_difference(grid_points(cloud.points(), request), hills), 5000);
  request.drop_outliers = 200;
  const auto grid = grid_points(cloud.points(), request);
  EXPECT_EQ(grid.outliers, 10);
  EXPECT_EQ(grid.heights.samples(),
            grid_points(clean.points(), {.spacing = WorldPoint{1, 1}}).heights.samples());
}

TEST(bad_points, requests_without_sense_are_refused) {
  const Cloud cloud = test::random_cloud(10, hills);
  expect_refusal(cloud, {}, "either the spacing or the size");
  expect_refusal(cloud, {.spacing = WorldPoint{1, 1}, .size = Extent{5, 5}}, "either");
  expect_refusal(cloud, {.spacing = WorldPoint{0, 1}}, "positive");
  expect_refusal(cloud, {.spacing = WorldPoint{nan, nan}}, "positive");
  expect_refusal(cloud, {.spacing = WorldPoint{1e-6, 1e-6}}, "2^31");
  expect_refusal(cloud, {.size = Extent{1, 9}}, "2 x 2");
  expect_refusal(cloud, {.size = Extent{9, 9}, .box = cgal::PlaneBox{5, 0, 2, 9}}, "empty");
  expect_refusal(cloud, {.size = Extent{9, 9}, .box = cgal::PlaneBox{500, 500, 600, 600}},
                 "inside the hull");
  expect_refusal(cloud, {.spacing = WorldPoint{1, 1}, .neighbours = 0}, "neighbours");
  expect_refusal(cloud, {.spacing = WorldPoint{1, 1}, .power = -1}, "power");
  expect_refusal(cloud, {.spacing = WorldPoint{1, 1}, .drop_outliers = 0}, "positive");
  Cloud line;
  for (int i = 0; i < 5; ++i) line.add(i, 0, 1);
  expect_refusal(line, {.size = Extent{5, 5}}, "no area");
  Cloud far;
  for (const double x : {0.0, 1.0})
    for (const double y : {0.0, 1.0}) far.add(1e15 + x, y, 1);
  expect_refusal(far, {.spacing = WorldPoint{0.5, 0.5}}, "tell apart");
}

TEST(bad_points, huge_coordinates_are_gridded) {
  Cloud cloud;
  for (const double x : {0.0, 0.5, 1.0})
    for (const double y : {0.0, 0.3, 1.0}) cloud.add(x * 1e149, y * 1e149, x + y);
  const auto grid = grid_points(cloud.points(), {.size = Extent{5, 5}});
  EXPECT_NEAR(grid.heights(2, 2), 1, 1e-10);
  EXPECT_EQ(grid.missing, 0);
}

TEST(bad_points, stopping_is_heard_and_comes_out) {
  const Cloud cloud = test::random_cloud(2000, hills);
  GridRequest request{.spacing = WorldPoint{0.5, 0.5}, .threads = 3};
  request.progress = [](double share) {
    if (share > 0.6) throw std::runtime_error("enough");
  };
  EXPECT_THROW((void)grid_points(cloud.points(), request), std::runtime_error);
}

}  // namespace
}  // namespace arete
