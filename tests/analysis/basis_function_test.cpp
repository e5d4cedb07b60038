// SPDX-License-Identifier: MIT
#include "arete/analysis/basis_function.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "arete/analysis/hoelder.h"
#include "arete/analysis/limit_stencil.h"
#include "arete/scheme/catalogue.h"

namespace arete {
namespace {

double at(const BasisSamples& samples, double x) {
  const double place = (x - samples.first) / samples.spacing;
  const auto i = static_cast<std::ptrdiff_t>(std::floor(place));
  if (i < 0 || i + 1 >= static_cast<std::ptrdiff_t>(samples.values.size())) return 0;
  const double share = place - static_cast<double>(i);
  const auto k = static_cast<std::size_t>(i);
  return samples.values[k] * (1 - share) + samples.values[k + 1] * share;
}

// The cubic B-spline and its derivatives in closed form.
TEST(BasisFunction, OfTheCubicSplineIsTheSpline) {
  const std::function<double(double)> exact[] = {
      [](double x) {
        const double a = std::abs(x);
        return a < 1   ? 2.0 / 3 - a * a + a * a * a / 2
               : a < 2 ? (2 - a) * (2 - a) * (2 - a) / 6
                       : 0.0;
      },
      [](double x) {
        const double a = std::abs(x);
        const double slope = a < 1 ? -2 * a + 1.5 * a * a : a < 2 ? -(2 - a) * (2 - a) / 2 : 0.0;
        return x < 0 ? -slope : slope;
      },
      [](double x) {
        const double a = std::abs(x);
        return a < 1 ? -2 + 3 * a : a < 2 ? 2 - a : 0.0;
      }};
  const Mask mask = make_scheme("b-spline").mask();
  for (int order = 0; order < 3; ++order) {
    const BasisSamples samples = basis_function(mask, order);
    EXPECT_GE(samples.values.size(), 1500u);
    for (double x = -2.4; x < 2.4; x += 0.0317)
      EXPECT_NEAR(at(samples, x), exact[order](x), 0.01) << order << " at " << x;
  }
}

// The weights of limits and derivatives at old samples are values of phi at the integers: p_j has
// the weight phi^(order)(-j).
TEST(BasisFunction, HasTheExactValuesOfTheStencilsAtTheIntegers) {
  for (const char* text :
       {"b-spline:degree=5", "four-point", "gentle", "ternary-two-step-9", "ternary-four-point",
        "four-parameter:lambda=3/32,mu=1/32,nu=1/4,omega=1/32", "chaikin"}) {
    const Mask mask = parse_scheme(text).mask();
    const double alpha = hoelder_bounds(mask).lower;
    for (int order = 0; order < 3; ++order) {
      const auto stencil = derivative_stencil(mask, order);
      // Samples of a derivative tend to it like m^{-L (alpha - order)}: skip what is too slow.
      if (!stencil || alpha < order + 0.5) continue;
      const BasisSamples samples = basis_function(mask, order, 20000);
      for (int j = -8; j <= 8; ++j) {
        const int k = j - stencil->first;
        const bool inside = k >= 0 && k < static_cast<int>(stencil->weights.size());
        const double weight =
            inside ? to_double(stencil->weights[static_cast<std::size_t>(k)]) : 0.0;
        EXPECT_NEAR(at(samples, -j), weight, 0.05 * (order + 0.2))
            << text << " " << order << " " << j;
      }
    }
  }
}

TEST(BasisFunction, KeepsHighDerivativesFreeOfRounding) {
  // The 30th derivative of the spline of degree 31 is piecewise linear between +-binomials.
  const Mask mask = make_scheme("b-spline", {{"degree", {31}}}).mask();
  const BasisSamples samples = basis_function(mask, 30);
  const BasisSamples once_more = basis_function(mask, 31);
  double binomial = 1;
  double largest = 0;
  for (int k = 0; k <= 15; ++k) {
    largest = binomial;
    binomial = binomial * (31 - k) / (k + 1);
  }
  double most = 0;
  for (const double value : once_more.values) most = std::max(most, std::abs(value));
  EXPECT_NEAR(most, largest, 1e-6 * largest);
  for (std::size_t i = 1; i < samples.values.size(); ++i)
    EXPECT_LE(std::abs(samples.values[i] - samples.values[i - 1]),
              largest * samples.spacing * (1 + 1e-9));
}

TEST(BasisFunction, RefusesDerivativesWithoutSumRules) {
  EXPECT_THROW((void)basis_function(make_scheme("craggy").mask(), 3), std::invalid_argument);
  EXPECT_THROW((void)basis_function(make_scheme("craggy").mask(), -1), std::invalid_argument);
}

}  // namespace
}  // namespace arete
