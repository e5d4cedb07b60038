// SPDX-License-Identifier: MIT
#include "arete/analysis/limit_stencil.h"

#include <gtest/gtest.h>

#include <map>

#include "analysis/oracle_scheme.h"

namespace arete {
namespace {

using test::exact;

std::map<int, Rational> weights_of(const std::optional<Stencil>& stencil) {
  std::map<int, Rational> weights;
  if (stencil)
    for (std::size_t i = 0; i < stencil->weights.size(); ++i)
      if (stencil->weights[i] != 0)
        weights[stencil->first + static_cast<int>(i)] = stencil->weights[i];
  return weights;
}

std::map<int, Rational> expected_weights(const nlohmann::json& object) {
  std::map<int, Rational> weights;
  for (const auto& [offset, weight] : object.items())
    if (exact(weight) != 0) weights[std::stoi(offset)] = exact(weight);
  return weights;
}

TEST(LimitStencil, MeetsTheParametricOracle) {
  for (const auto& record : test::parametric_records("p0.limit_stencil")) {
    SCOPED_TRACE(record.at("id").get<std::string>());
    const Mask mask = test::mask_of(record.at("input"));
    const auto& expect = record.at("expect");
    EXPECT_EQ(weights_of(limit_stencil(mask)), expected_weights(expect.at("limit")));
    const auto derivative = derivative_stencil(mask);
    EXPECT_EQ(derivative.has_value(), expect.contains("derivative"));
    if (expect.contains("derivative")) {
      EXPECT_EQ(weights_of(derivative), expected_weights(expect.at("derivative")));
    }
  }
}

TEST(LimitStencil, MeetsTheTernaryOracle) {
  for (const auto& record : test::ternary_and_reverse_records("t.limit_stencils")) {
    SCOPED_TRACE(record.at("id").get<std::string>());
    const Mask mask =
        make_scheme("ternary-two-step-9", {{"b", {exact(record.at("input").at("b"))}}}).mask();
    const auto& expect = record.at("expect");
    const char* const keys[] = {"position", "first_derivative", "second_derivative"};
    for (int order = 0; order < 3; ++order) {
      std::map<int, Rational> expected;
      const auto list = test::exact_list(expect.at(keys[order]));
      for (int i = 0; i < 7; ++i)
        if (list[static_cast<std::size_t>(i)] != 0)
          expected[i - 3] = list[static_cast<std::size_t>(i)];
      EXPECT_EQ(weights_of(derivative_stencil(mask, order)), expected) << keys[order];
    }
  }
}

// Splines of odd degree have the values of the cardinal B-spline; even degrees are dual.
TEST(LimitStencil, OfSplines) {
  const auto stencil = [](int degree) {
    return limit_stencil(make_scheme("b-spline", {{"degree", {degree}}}).mask());
  };
  EXPECT_EQ(stencil(3), (Stencil{-1, {Rational(1, 6), Rational(2, 3), Rational(1, 6)}}));
  ASSERT_TRUE(stencil(2).has_value());
  EXPECT_EQ(stencil(2)->weights, (std::vector<Rational>{Rational(1, 2), Rational(1, 2)}));
  EXPECT_EQ(weights_of(derivative_stencil(make_scheme("b-spline").mask(), 2)),
            (std::map<int, Rational>{{-1, 1}, {0, -2}, {1, 1}}));
}

// The limit does not change when one step is taken first: f(0) read from the refined samples.
TEST(LimitStencil, IsUnchangedByOneStep) {
  for (const Family& family : catalogue()) {
    if (family.name == "mask" || family.name == "difference") continue;
    SCOPED_TRACE(family.name);
    const Mask mask = make_scheme(family.name).mask();
    const auto weights = weights_of(limit_stencil(mask));
    if (weights.empty()) continue;
    std::map<int, Rational> through_one_step;
    for (const auto& [k, weight] : weights)
      for (int j = -100; j <= 100; ++j)
        if (mask[k - mask.arity() * j] != 0)
          through_one_step[j] += weight * mask[k - mask.arity() * j];
    std::erase_if(through_one_step, [](const auto& entry) { return entry.second == 0; });
    EXPECT_EQ(through_one_step, weights);
  }
}

TEST(LimitStencil, OfInterpolatorySchemesIsTheSampleItself) {
  for (const char* name :
       {"four-point", "three-point", "ternary-two-step-9", "ternary-four-point"}) {
    const auto stencil = limit_stencil(make_scheme(name).mask());
    ASSERT_TRUE(stencil.has_value()) << name;
    EXPECT_EQ(*stencil, (Stencil{0, {Rational(1)}})) << name;
  }
}

TEST(LimitStencil, IsRefusedWithoutACertificate) {
  EXPECT_EQ(limit_stencil(make_scheme("four-point", {{"omega", {Rational(1, 2)}}}).mask()),
            std::nullopt);
  EXPECT_EQ(derivative_stencil(make_scheme("four-point").mask(), 2), std::nullopt);
  EXPECT_EQ(derivative_stencil(make_scheme("craggy").mask(), 1), std::nullopt);
  EXPECT_THROW((void)derivative_stencil(make_scheme("craggy").mask(), -1), std::invalid_argument);
}

}  // namespace
}  // namespace arete
