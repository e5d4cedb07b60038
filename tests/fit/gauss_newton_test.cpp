// SPDX-License-Identifier: MIT
#include "arete/fit/gauss_newton.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace arete {
namespace {

using Values = std::vector<double>;

TEST(gauss_newton, solves_a_linear_model_by_one_step) {
  const Model line = [](const Values& p) -> std::optional<Values> {
    Values v;
    for (int x = 0; x < 6; ++x) v.push_back(p[0] + p[1] * x);
    return v;
  };
  // The regression line of these six numbers: slope 31/35 through (2.5, 3.5).
  const Values target{1, 3, 2, 5, 4, 6};
  const auto fit = gauss_newton(line, target, std::vector<char>(6, 1), {0, 0});
  EXPECT_TRUE(fit.converged);
  EXPECT_LE(fit.steps, 3);
  EXPECT_NEAR(fit.parameters[1], 31.0 / 35, 1e-12);
  EXPECT_NEAR(fit.parameters[0], 3.5 - 2.5 * 31.0 / 35, 1e-12);
}

TEST(gauss_newton, leaves_out_what_does_not_count) {
  const Model constant = [](const Values& p) -> std::optional<Values> { return Values(4, p[0]); };
  const auto fit = gauss_newton(constant, {1, 1000, 3, -1000}, {1, 0, 1, 0}, {0});
  EXPECT_NEAR(fit.parameters[0], 2, 1e-12);
  EXPECT_NEAR(fit.sum_of_squares, 2, 1e-12);
}

TEST(gauss_newton, finds_rosenbrocks_minimum_from_its_usual_start) {
  const Model valley = [](const Values& p) -> std::optional<Values> {
    return Values{10 * (p[1] - p[0] * p[0]), p[0]};
  };
  const auto fit = gauss_newton(valley, {0, 1}, {1, 1}, {-1.2, 1});
  EXPECT_NEAR(fit.parameters[0], 1, 1e-9);
  EXPECT_NEAR(fit.parameters[1], 1, 1e-9);
}

TEST(gauss_newton, stays_where_there_is_a_model) {
  // No model below 1; the best of the rest is at its edge.
  const Model guarded = [](const Values& p) -> std::optional<Values> {
    if (p[0] < 1) return std::nullopt;
    return Values{p[0]};
  };
  const auto fit = gauss_newton(guarded, {0}, {1}, {5});
  EXPECT_GE(fit.parameters[0], 1);
  EXPECT_LT(fit.parameters[0], 1.1);
  EXPECT_THROW((void)gauss_newton(guarded, {0}, {1}, {0}), std::invalid_argument);
}

}  // namespace
}  // namespace arete
