// SPDX-License-Identifier: MIT
// Noise gains: those of the specification, and those that are measured.
#include "arete/reverse/condition.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "arete/reverse/curve_reverse.h"
#include "arete/scheme/catalogue.h"
#include "support/schemes.h"

namespace arete {
namespace {

TEST(reverse_condition, noise_gains_are_those_of_the_specification) {
  const auto gain = [](const char* scheme, ReverseMode mode) {
    return reverse_condition(parse_scheme(scheme).mask(), mode)->noise_gain;
  };
  constexpr auto local = ReverseMode::local;
  constexpr auto best = ReverseMode::least_squares;
  EXPECT_NEAR(gain("chaikin", local), 1.118, 5e-4);
  EXPECT_NEAR(gain("chaikin", best), 1, 1e-12);  // mean of 1/(5/4 + 3/4 cos) is 1
  EXPECT_NEAR(gain("b-spline:degree=3", local), 2.121, 5e-4);
  EXPECT_NEAR(gain("b-spline:degree=3", best), 1.210, 1e-2);
  EXPECT_NEAR(gain("four-point", local), 1, 1e-15);
  EXPECT_NEAR(gain("four-point", best), 0.804, 5e-3);
  EXPECT_NEAR(gain("ternary-two-step:b=1/10", best), 0.648, 5e-3);
}

TEST(reverse_condition, is_what_white_noise_and_the_worst_wave_show) {
  for (const Scheme& scheme : test::sample_schemes())
    for (const ReverseMode mode : {ReverseMode::local, ReverseMode::least_squares}) {
      const auto stated = reverse_condition(scheme.mask(), mode);
      if (!stated) continue;
      const Index n = 300;
      const Index m = scheme.mask().arity();
      // The analysis matrix of a closed axis, from unit impulses.
      const AxisReverse<double> axis(scheme.mask(), n * m, Boundary::periodic, mode);
      Grid<double> fine({n * m, m});
      for (Index k = 0; k < m; ++k) fine(n * m / 2 + k, k) = 1;
      Grid<double> coarse({n, m});
      Grid<double> details({axis.detail_count(), m});
      axis.analyse({fine.row(0), n * m, m, m}, {coarse.row(0), n, m, m},
                   {details.row(0), details.rows(), m, m});
      double squared = 0;
      for (const double value : coarse.samples()) squared += value * value;
      EXPECT_NEAR(std::sqrt(squared), stated->noise_gain, 1e-9 * stated->noise_gain)
          << scheme.text();
      EXPECT_GE(stated->condition, 1 - 1e-12) << scheme.text();
      // No data are amplified more, relative to what they came from.
      std::mt19937 random(1);
      std::normal_distribution<double> normal;
      for (double& value : fine.samples()) value = normal(random);
      axis.analyse({fine.row(0), n * m, m, m}, {coarse.row(0), n, m, m},
                   {details.row(0), details.rows(), m, m});
      double in = 0;
      double out = 0;
      for (const double value : fine.samples()) in += value * value;
      for (const double value : coarse.samples()) out += value * value;
      EXPECT_LE(std::sqrt(out / in), stated->condition * (1 + 1e-9)) << scheme.text();
    }
}

TEST(reverse_condition, there_is_none_without_a_reverse) {
  // u + v = 1: both new samples are the same.
  EXPECT_FALSE(
      reverse_condition(parse_scheme("corner-cutting:u=1/2,v=1/2").mask(), ReverseMode::local));
  EXPECT_FALSE(reverse_condition(parse_scheme("gentle").mask(), ReverseMode::local));
  EXPECT_TRUE(reverse_condition(parse_scheme("gentle").mask(), ReverseMode::least_squares));
}

}  // namespace
}  // namespace arete
