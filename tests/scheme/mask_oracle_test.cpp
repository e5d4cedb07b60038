// SPDX-License-Identifier: MIT
// Every mask record of the oracle files, exactly.
#include <gtest/gtest.h>

#include "arete/scheme/catalogue.h"
#include "arete/scheme/family/difference.h"
#include "arete/scheme/family/ternary.h"
#include "support/oracle.h"

namespace arete {
namespace {

using test::exact;
using test::exact_list;

Scheme four_parameter(const nlohmann::json& input) {
  return make_scheme("four-parameter", {{"lambda", {exact(input.at("lambda"))}},
                                        {"mu", {exact(input.at("mu"))}},
                                        {"nu", {exact(input.at("nu"))}},
                                        {"omega", {exact(input.at("omega"))}}});
}

void expect_mask(const Mask& mask, const nlohmann::json& expect, const std::string& id) {
  EXPECT_EQ(mask.first(), expect.at("lo").get<int>()) << id;
  EXPECT_EQ(mask.coefficients(), exact_list(expect.at("mask"))) << id;
}

TEST(mask_oracle, four_parameter_masks) {
  for (const auto& record : test::parametric_records("p0.mask"))
    expect_mask(four_parameter(record.at("input")).mask(), record.at("expect"), record.at("id"));
}

TEST(mask_oracle, two_and_three_parameter_masks) {
  for (const auto& record : test::parametric_records("p1.scheme3"))
    expect_mask(make_scheme("two-parameter", {{"a", {exact(record.at("input").at("a"))}}}).mask(),
                record.at("expect"), record.at("id"));
  for (const auto& record : test::parametric_records("p1.scheme5"))
    expect_mask(make_scheme("three-parameter", {{"a", {exact(record.at("input").at("a"))}},
                                                {"c", {exact(record.at("input").at("c"))}}})
                    .mask(),
                record.at("expect"), record.at("id"));
}

TEST(mask_oracle, schemes_built_from_difference_symbols) {
  for (const auto& record : test::parametric_records("p1.build")) {
    const auto& input = record.at("input");
    ParameterValues values{{"m", {input.at("m").get<int>()}},
                           {"raise", {input.at("raise_k").get<int>()}}};
    int i = 0;
    for (const Rational& c : exact_list(input.at("coef_ascending")))
      values.push_back({"a" + std::to_string(i++), {c}});
    const Mask raised = make_scheme("difference", values).mask();
    // The record counts from z^0.
    EXPECT_EQ(raised.coefficients(), exact_list(record.at("expect").at("raised").at("mask")));
    values[1].numbers = {0};
    EXPECT_EQ(make_scheme("difference", values).mask().coefficients(),
              exact_list(record.at("expect").at("S").at("mask")));
  }
}

TEST(mask_oracle, ternary_masks_of_one_and_two_steps) {
  for (const auto& record : test::ternary_and_reverse_records("t.mask")) {
    const Rational b = exact(record.at("input").at("b"));
    const Mask mask = make_scheme("ternary-two-step", {{"b", {b}}}).mask();
    expect_mask(mask, record.at("expect"), record.at("id"));
    EXPECT_EQ(mask.tau(), exact(record.at("expect").at("tau")));
  }
  for (const auto& record : test::ternary_and_reverse_records("t.two_step_mask")) {
    const Rational b = exact(record.at("input").at("b"));
    const Mask mask = make_scheme("ternary-two-step-9", {{"b", {b}}}).mask();
    expect_mask(mask, record.at("expect"), record.at("id"));
    EXPECT_EQ(mask.arity(), record.at("expect").at("arity").get<int>());
    EXPECT_EQ(mask.tau(), 0);
  }
}

TEST(mask_oracle, two_ternary_steps_interpolate_for_a_symbolic_b) {
  // The formula over the ring Q[b]: c_{9k} = delta_k is an identity in b, not a check of samples.
  using Ring = LaurentPolynomial<Rational>;
  const Ring b = Ring::monomial(1, 1);
  const auto symbol = family::ternary_two_step_9<Ring>(b);
  for (int k = -2; k <= 2; ++k) EXPECT_EQ(symbol[9 * k], Ring(k == 0 ? 1 : 0)) << k;
  for (int k = 0; k <= 26; ++k) EXPECT_EQ(symbol[k], symbol[-k]) << k;
}

TEST(mask_oracle, formulas_give_the_same_numbers_over_doubles) {
  for (const auto& record : test::ternary_and_reverse_records("t.two_step_mask")) {
    const Rational b = exact(record.at("input").at("b"));
    const auto symbol = family::ternary_two_step_9<double>(to_double(b));
    const Mask mask = make_scheme("ternary-two-step-9", {{"b", {b}}}).mask();
    for (int k = mask.first(); k <= mask.last(); ++k)
      EXPECT_NEAR(symbol[k], to_double(mask[k]), 1e-15) << k;
  }
}

}  // namespace
}  // namespace arete
