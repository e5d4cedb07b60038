// SPDX-License-Identifier: MIT
// Known parameters come back from synthetic terrain; nothing beats the best by construction.
#include "arete/fit/fit_scheme.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "arete/refine/refiner.h"
#include "arete/scheme/catalogue.h"
#include "support/fields.h"

namespace arete {
namespace {

// Terrain that a scheme makes of random heights.
FitData made_by(const char* scheme, int factor, Prediction mode = Prediction::direct,
                Extent coarse = {30, 26}) {
  FitData data;
  data.coarse = test::random_heights(coarse);
  data.factor = factor;
  data.truth = predict(data.coarse.view(), parse_scheme(scheme), factor, mode);
  return data;
}

double parameter(const Scheme& scheme, const char* name) {
  return to_double(number(scheme.parameters(), name));
}

TEST(fit_scheme, recovers_the_tension_of_interpolatory_schemes) {
  for (const int factor : {2, 4}) {
    const auto fit = fit_scheme(made_by("four-point:omega=0.0871", factor),
                                ParameterSpace(parse_scheme("four-point"), {}), Prediction::direct,
                                FitCriterion::rmse);
    EXPECT_TRUE(fit.converged);
    EXPECT_NEAR(parameter(fit.scheme, "omega"), 0.0871, 1e-6) << factor;
    EXPECT_LE(fit.rmse, 1e-6);
    EXPECT_LE(fit.cross_validated_rmse, 1e-6);
  }
}

TEST(fit_scheme, recovers_all_parameters_of_approximating_schemes_from_given_coarse_samples) {
  FitData data = made_by("four-parameter:lambda=0.21,mu=0.21,nu=1/2,omega=0.05", 2);
  data.coarse_is_given = true;
  const auto fit = fit_scheme(data, ParameterSpace(parse_scheme("four-parameter"), {}),
                              Prediction::direct, FitCriterion::rmse);
  EXPECT_NEAR(parameter(fit.scheme, "lambda"), 0.21, 1e-6);
  EXPECT_NEAR(parameter(fit.scheme, "mu"), 0.21, 1e-6);
  EXPECT_NEAR(parameter(fit.scheme, "omega"), 0.05, 1e-6);
}

TEST(fit_scheme, recovers_a_mask_and_a_ternary_scheme) {
  const auto mask = fit_scheme(
      made_by("mask:arity=2,first=-3,coefficients=-0.05;0;0.55;1;0.55;0;-0.05", 2),
      ParameterSpace(parse_scheme("mask:arity=2,first=-3,coefficients=-1/16;0;9/16;1;9/16;0;-1/16"),
                     {}),
      Prediction::direct, FitCriterion::rmse);
  const std::vector<double> expected{-0.05, 0, 0.55, 1, 0.55, 0, -0.05};
  for (int k = -3; k <= 3; ++k)
    EXPECT_NEAR(to_double(mask.scheme.mask()[k]), expected[static_cast<std::size_t>(k + 3)], 1e-6)
        << k;
  const auto ternary = fit_scheme(made_by("ternary-four-point:mu=0.08", 3),
                                  ParameterSpace(parse_scheme("ternary-four-point"), {}),
                                  Prediction::direct, FitCriterion::rmse);
  EXPECT_NEAR(parameter(ternary.scheme, "mu"), 0.08, 1e-6);
}

TEST(fit_scheme, recovers_parameters_in_cardinal_mode) {
  const auto fit = fit_scheme(made_by("four-parameter-c2:omega=0.04", 2, Prediction::interpolating),
                              ParameterSpace(parse_scheme("four-parameter-c2"), {}),
                              Prediction::interpolating, FitCriterion::rmse);
  EXPECT_NEAR(parameter(fit.scheme, "omega"), 0.04, 1e-6);
}

TEST(fit_scheme, recovers_roughness) {
  const auto fit = fit_scheme(made_by("four-point:omega=0.12", 2, Prediction::direct, {70, 90}),
                              ParameterSpace(parse_scheme("four-point"), {}), Prediction::direct,
                              FitCriterion::roughness);
  EXPECT_NEAR(parameter(fit.scheme, "omega"), 0.12, 1e-6);
  EXPECT_TRUE(std::isnan(fit.cross_validated_rmse));
}

TEST(fit_scheme, no_member_beside_the_fitted_one_predicts_better) {
  // Terrain of another make: no member fits exactly.
  const FitData data = fit_data(predict(test::random_heights({40, 40}).view(),
                                        parse_scheme("b-spline:degree=5"), 4, Prediction::direct),
                                2);
  const ParameterSpace space(parse_scheme("four-parameter"), {});
  const auto fit = fit_scheme(data, space, Prediction::direct, FitCriterion::rmse);
  const auto counts = held_out(data);
  const auto rmse = [&](const Scheme& scheme) {
    const Grid<double> p = predict(data.coarse.view(), scheme, 2, Prediction::direct);
    double squares = 0;
    double n = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
      const auto r = static_cast<Index>(i) / data.truth.cols();
      const auto c = static_cast<Index>(i) % data.truth.cols();
      if (counts[i] == 0) continue;
      squares += std::pow(p(r, c) - data.truth(r, c), 2);
      ++n;
    }
    return std::sqrt(squares / n);
  };
  EXPECT_NEAR(rmse(fit.scheme), fit.rmse, 1e-12 * fit.rmse);
  EXPECT_GE(fit.cross_validated_rmse, fit.rmse);
  for (const char* name : {"lambda", "omega"})
    for (const int sign : {-1, 1}) {
      ParameterValues values = fit.scheme.parameters();
      for (ParameterValue& v : values)
        if (v.name == name || (v.name == "mu" && std::string(name) == "lambda"))
          v.numbers[0] += Rational(sign, 1000);
      EXPECT_GT(rmse(make_scheme("four-parameter", values)), fit.rmse) << name;
    }
}

TEST(fit_scheme, missing_truth_and_missing_coarse_samples_do_not_count) {
  FitData data = made_by("four-point:omega=0.09", 2);
  data.truth(20, 21) = std::numeric_limits<double>::quiet_NaN();
  data.coarse(14, 12) = std::numeric_limits<double>::quiet_NaN();
  const auto fit = fit_scheme(data, ParameterSpace(parse_scheme("four-point"), {}),
                              Prediction::direct, FitCriterion::rmse);
  EXPECT_TRUE(std::isfinite(fit.rmse));
  // Beside the hole samples are continued, which is no law of the scheme.
  EXPECT_NEAR(parameter(fit.scheme, "omega"), 0.09, 0.02);
}

TEST(fit_scheme, what_cannot_be_fitted_is_refused) {
  const ParameterSpace space(parse_scheme("four-point"), {});
  FitData data = made_by("four-point", 2, Prediction::direct, {9, 9});
  EXPECT_THROW((void)fit_scheme(data, space, Prediction::direct, FitCriterion::rmse), InvalidField);
  data = fit_data(made_by("four-point", 2).truth, 3);
  EXPECT_THROW((void)fit_scheme(data, space, Prediction::direct, FitCriterion::rmse), InvalidField);
  data = made_by("four-point", 2);
  data.coarse = test::random_heights({5, 5});
  EXPECT_THROW((void)fit_scheme(data, space, Prediction::direct, FitCriterion::rmse), InvalidField);
  data = made_by("four-point", 2);
  EXPECT_THROW((void)fit_scheme(data, ParameterSpace(parse_scheme("corner-cutting"), {}),
                                Prediction::direct, FitCriterion::rmse),
               InvalidScheme);
}

TEST(fit_scheme, threads_do_not_change_the_result) {
  FitData data = made_by("b-spline:degree=5", 2);
  const ParameterSpace space(parse_scheme("four-point"), {});
  const auto one = fit_scheme(data, space, Prediction::direct, FitCriterion::rmse);
  data.threads = 3;
  const auto three = fit_scheme(data, space, Prediction::direct, FitCriterion::rmse);
  EXPECT_EQ(one.scheme, three.scheme);
  EXPECT_EQ(one.rmse, three.rmse);
}

}  // namespace
}  // namespace arete
