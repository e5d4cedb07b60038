// SPDX-License-Identifier: MIT
#include "arete/metrics/difference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "arete/metrics/slope.h"
#include "support/fields.h"

namespace arete {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(compare_heights, of_a_shifted_field_is_the_shift) {
  const Grid<double> a = test::random_heights({31, 17});
  Grid<double> b = a;
  for (double& z : b.samples()) z -= 3;
  const HeightDifference d = compare_heights(a.view(), b.view());
  EXPECT_EQ(d.compared, 31 * 17);
  EXPECT_NEAR(d.rmse, 3, 1e-12);
  EXPECT_NEAR(d.mean, -3, 1e-12);
  EXPECT_NEAR(d.mean_absolute, 3, 1e-12);
  EXPECT_NEAR(d.largest, 3, 1e-12);
}

TEST(compare_heights, finds_the_one_sample_that_differs) {
  const Grid<double> a = test::random_heights({9, 12});
  Grid<double> b = a;
  b(4, 7) += 6;
  b(2, 1) -= 1;
  const HeightDifference d = compare_heights(a.view(), b.view());
  EXPECT_NEAR(d.rmse, std::sqrt(37.0 / 108), 1e-12);
  EXPECT_NEAR(d.mean, 5.0 / 108, 1e-12);
  EXPECT_NEAR(d.mean_absolute, 7.0 / 108, 1e-12);
  EXPECT_EQ(d.largest_row, 4);
  EXPECT_EQ(d.largest_col, 7);
}

TEST(compare_heights, missing_samples_are_counted_and_left_out) {
  Grid<double> a({3, 4}, 1.0);
  Grid<double> b({3, 4}, 2.0);
  a(0, 0) = nan;
  a(1, 1) = b(1, 1) = nan;
  b(2, 2) = std::numeric_limits<double>::infinity();
  b(2, 3) = nan;
  const HeightDifference d = compare_heights(a.view(), b.view());
  EXPECT_EQ(d.compared, 8);
  EXPECT_EQ(d.only_first, 2);
  EXPECT_EQ(d.only_second, 1);
  EXPECT_EQ(d.rmse, 1);
  const HeightDifference none =
      compare_heights(Grid<double>({2, 2}, nan).view(), Grid<double>({2, 2}).view());
  EXPECT_EQ(none.compared, 0);
  EXPECT_TRUE(std::isnan(none.rmse) && std::isnan(none.mean) && std::isnan(none.largest));
}

TEST(compare_heights, refuses_other_extents) {
  EXPECT_THROW((void)compare_heights(Grid<double>({2, 3}).view(), Grid<double>({3, 2}).view()),
               InvalidField);
}

TEST(slope, of_a_plane_is_its_angle_everywhere_inside) {
  // 30 per column at columns 10 apart, -20 per row at rows 5 apart: steepness 5.
  const Grid<double> z = test::plane<double>({6, 7}, 100, -20, 30);
  std::vector<double> out(7);
  for (Index r = 0; r < 6; ++r) {
    slope_degrees(z.view(), {10, 5}, r, out.data());
    for (Index c = 0; c < 7; ++c) {
      const bool inside = r > 0 && r < 5 && c > 0 && c < 6;
      const double expected = inside ? std::atan(5.0) * 180 / M_PI : nan;
      const double slope = out[static_cast<std::size_t>(c)];
      EXPECT_TRUE(std::abs(slope - expected) < 1e-12 || (std::isnan(slope) && !inside)) << slope;
    }
  }
}

TEST(compare_slopes, of_two_planes_is_the_difference_of_their_angles) {
  const Grid<double> a = test::plane<double>({8, 8}, 0, 0, 10);
  const Grid<double> b = test::plane<double>({8, 8}, 50, 0, 0);
  const SlopeDifference d = compare_slopes(a.view(), b.view(), {10, 10});
  EXPECT_EQ(d.compared, 36);
  EXPECT_NEAR(d.rmse, 45, 1e-12);
  Grid<double> hole = a;
  hole(4, 4) = nan;
  EXPECT_EQ(compare_slopes(hole.view(), b.view(), {10, 10}).compared, 36 - 9);
  EXPECT_THROW((void)compare_slopes(a.view(), b.view(), {0, 10}), InvalidField);
}

}  // namespace
}  // namespace arete
