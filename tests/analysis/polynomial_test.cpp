// SPDX-License-Identifier: MIT
#include "arete/analysis/polynomial.h"

#include <gtest/gtest.h>

#include "analysis/oracle_scheme.h"

namespace arete {
namespace {

using test::exact;

TEST(Polynomial, MeetsTheParametricOracle) {
  for (const auto& record : test::parametric_records("p0.polynomial")) {
    SCOPED_TRACE(record.at("id").get<std::string>());
    const Mask mask = test::mask_of(record.at("input"));
    const auto& expect = record.at("expect");
    EXPECT_EQ(mask.tau(), exact(expect.at("tau")));
    EXPECT_EQ(sum_rules(mask), expect.at("factors_1pz").get<int>());
    EXPECT_EQ(reproduction_degree(mask), expect.at("reproduction_degree").get<int>());
  }
}

TEST(Polynomial, MeetsTheTernaryOracle) {
  for (const auto& record : test::ternary_and_reverse_records("t.mask")) {
    SCOPED_TRACE(record.at("id").get<std::string>());
    const Mask mask = test::ternary_mask(record.at("input"));
    const auto& expect = record.at("expect");
    EXPECT_EQ(mask.tau(), exact(expect.at("tau")));
    EXPECT_EQ(sum_rules(mask), expect.at("sum_rules").get<int>());
    EXPECT_EQ(reproduction_degree(mask), expect.at("reproduction_degree").get<int>());
    EXPECT_EQ(is_interpolatory(mask), expect.at("interpolatory").get<bool>());
  }
}

TEST(Polynomial, TwoStepsReproduceWhatOneDoes) {
  for (const Family& family : catalogue()) {
    if (family.name == "mask" || family.name == "difference") continue;
    SCOPED_TRACE(family.name);
    const Mask mask = make_scheme(family.name).mask();
    if (mask.coefficients().size() > 30) continue;
    const Mask twice = iterated(mask, 2);
    EXPECT_EQ(sum_rules(twice), sum_rules(mask));
    EXPECT_EQ(reproduction_degree(twice), reproduction_degree(mask));
  }
}

TEST(Polynomial, InterpolatoryMembers) {
  for (const char* name : {"four-point", "three-point", "ternary-two-step-9", "ternary-four-point",
                           "dubuc-deslauriers"})
    EXPECT_TRUE(is_interpolatory(make_scheme(name).mask())) << name;
  for (const char* name : {"chaikin", "de-rham", "gentle", "craggy", "ternary-two-step"})
    EXPECT_FALSE(is_interpolatory(make_scheme(name).mask())) << name;
}

TEST(Overshoot, IsTheLebesgueConstantOfOneStep) {
  // Known: 5/4 for the 4-point scheme at 1/16; no overshoot with non-negative masks.
  EXPECT_EQ(step_norm(make_scheme("four-point").mask()), Rational(5, 4));
  EXPECT_EQ(overshoot(make_scheme("four-point").mask()), Rational(1, 8));
  EXPECT_EQ(overshoot(make_scheme("b-spline").mask()), 0);
  // ||S|| = 5/4 of the ternary scheme at these parameters (its specification, 2.1).
  for (const char* b : {"-3/8", "-1/5", "0", "1/10", "1/6"})
    EXPECT_EQ(step_norm(make_scheme("ternary-two-step", {{"b", {parse_rational(b)}}}).mask()),
              Rational(5, 4))
        << b;
}

}  // namespace
}  // namespace arete
