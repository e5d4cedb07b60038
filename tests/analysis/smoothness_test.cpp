// SPDX-License-Identifier: MIT
#include "arete/analysis/smoothness.h"

#include <gtest/gtest.h>

#include <random>

#include "analysis/oracle_scheme.h"
#include "arete/analysis/limit_norm.h"
#include "arete/analysis/limit_stencil.h"
#include "arete/analysis/polynomial.h"
#include "arete/scheme/catalogue.h"

namespace arete {
namespace {

TEST(Smoothness, MeetsTheOracleIncludingTheReasons) {
  for (const auto& record : test::parametric_records("smoothness")) {
    SCOPED_TRACE(record.at("id").get<std::string>());
    const Smoothness found = analyze_smoothness(test::mask_of(record.at("input")));
    const auto& expect = record.at("expect");
    const int certified = expect.at("certified").get<int>();
    EXPECT_EQ(found.certified, certified);
    ASSERT_EQ(found.refuted_at, certified + 1);
    EXPECT_EQ(found.hoelder.stability == Stability::stable, expect.at("stable_shifts").get<bool>());
    const OrderVerdict& refuted = found.orders[static_cast<std::size_t>(certified + 1)];
    const std::string reason = expect.at("not_C" + std::to_string(certified + 1));
    if (reason.starts_with("word ")) {
      EXPECT_EQ(refuted.reason, Reason::word);
      EXPECT_EQ(to_text(refuted.word), reason.substr(5));
      EXPECT_NEAR(refuted.value, expect.at("word_value").get<double>(), 1e-9);
    } else {
      EXPECT_EQ(refuted.reason, Reason::sum_rules);
    }
  }
}

TEST(Smoothness, KnowsThePublishedLimitsOfTheFourPointScheme) {
  const auto order = [](const Rational& omega) {
    return analyze_smoothness(make_scheme("four-point", {{"omega", {omega}}}).mask());
  };
  // C^1 exactly for 0 < omega < 0.19273, the real root of 32 w^3 + 4 w - 1.
  const Rational below = parse_rational("0.1927");
  const Rational above = parse_rational("0.1928");
  EXPECT_LT(32 * below * below * below + 4 * below - 1, 0);
  EXPECT_GT(32 * above * above * above + 4 * above - 1, 0);
  EXPECT_EQ(order(below).certified, 1);
  EXPECT_EQ(order(above).refuted_at, 1);
  // And much closer to the root.
  Rational low = below, high = above;
  while (high - low > parse_rational("1e-7")) {
    const Rational w = (low + high) / 2;
    (32 * w * w * w + 4 * w - 1 < 0 ? low : high) = w;
  }
  EXPECT_EQ(order(low).certified, 1);
  EXPECT_EQ(order(high).refuted_at, 1);
  EXPECT_EQ(to_text(order(high).orders[1].word), "01");
  EXPECT_EQ(order(0).refuted_at, 1);
  EXPECT_EQ(order(Rational(1) / 2).refuted_at, 0);
  EXPECT_EQ(order(Rational(49) / 100).certified, 0);
}

TEST(Smoothness, KnowsThePublishedRangeOfTheTernaryFourPointScheme) {
  const auto order = [](const Rational& mu) {
    return analyze_smoothness(make_scheme("ternary-four-point", {{"mu", {mu}}}).mask());
  };
  EXPECT_EQ(order(Rational(1) / 15).refuted_at, 2);
  EXPECT_EQ(order(Rational(1) / 9).refuted_at, 2);
  EXPECT_EQ(order(Rational(1) / 15 + Rational(1) / 1000).certified, 2);
  EXPECT_EQ(order(Rational(1) / 9 - Rational(1) / 1000).certified, 2);
}

// On the C^2 family alpha = -log2(1/8 + 2 omega) for every nu in [0, 1].
TEST(Smoothness, OfTheC2FamilyDoesNotDependOnTheBalance) {
  for (const char* nu : {"0", "1/4", "1/2", "2/3", "1"})
    for (const char* omega : {"1/100", "1/32", "1/16", "1/8"}) {
      const Rational w = parse_rational(omega);
      const auto found = analyze_smoothness(
          make_scheme("four-parameter-c2", {{"nu", {parse_rational(nu)}}, {"omega", {w}}}).mask());
      EXPECT_EQ(found.hoelder.jsr.exact, Rational(1) / 8 + 2 * w) << nu << " " << omega;
      EXPECT_EQ(found.certified, w < Rational(1) / 16 ? 2 : 1) << nu << " " << omega;
    }
}

TEST(Stability, SeesBothKindsOfInstability) {
  // The stretched hat (1 + z^3)^2 / 2: phi(x) = hat(x/3)/3 has a 3-periodic zero of its transform.
  const Mask stretched(2, -3, {Rational(1) / 2, 0, 0, 1, 0, 0, Rational(1) / 2});
  EXPECT_EQ(shift_stability(stretched), Stability::unstable);
  // Symmetric zeros +-i.
  const Mask symmetric = make_scheme("four-parameter", {{"lambda", {Rational(1) / 4}},
                                                        {"mu", {Rational(1) / 4}},
                                                        {"omega", {Rational(1) / 16}}})
                             .mask();
  EXPECT_EQ(shift_stability(symmetric), Stability::unstable);
  for (const Family& family : catalogue()) {
    if (family.name == "mask" || family.name == "difference") continue;
    EXPECT_EQ(shift_stability(make_scheme(family.name).mask()), Stability::stable) << family.name;
  }
  // Where shifts are unstable no order above 0 may be called refuted. (The scheme of the stretched
  // hat splits the samples into three that never meet: it does not converge.)
  EXPECT_EQ(analyze_smoothness(symmetric).refuted_at, std::nullopt);
  EXPECT_EQ(analyze_smoothness(stretched).refuted_at, 0);
}

TEST(LimitNorm, BoundsTheLimitFromAbove) {
  for (const Family& family : catalogue()) {
    if (family.name == "mask" || family.name == "difference") continue;
    SCOPED_TRACE(family.name);
    const Mask mask = make_scheme(family.name).mask();
    const auto bound = limit_norm(mask);
    ASSERT_TRUE(bound.has_value());
    EXPECT_GE(bound->upper, 1);
    // The weights of the limit at an old sample are one of the sums that it bounds.
    Rational sum = 0;
    const auto stencil = limit_stencil(mask);
    ASSERT_TRUE(stencil.has_value());
    for (const Rational& weight : stencil->weights) sum += abs(weight);
    EXPECT_LE(sum, bound->upper);
    EXPECT_EQ(bound->upper == 1, step_norm(mask) == 1);
  }
  // Hassan's ternary scheme has the constant 5/4, the 4-point scheme about 1.2511.
  EXPECT_NEAR(to_double(limit_norm(make_scheme("ternary-four-point").mask())->upper), 1.25, 1e-6);
  EXPECT_NEAR(to_double(limit_norm(make_scheme("four-point").mask())->upper), 1.2511, 1e-4);
  EXPECT_EQ(limit_norm(make_scheme("four-point", {{"omega", {1}}}).mask()), std::nullopt);
}

// Any mask gets an answer, and no number overflows.
TEST(Smoothness, EndsOnHardMasks) {
  std::mt19937 random(1);
  for (const int taps : {24, 64, 300, 3000}) {
    std::vector<Rational> values;
    Rational even = 0;
    Rational odd = 0;
    for (int i = 0; i < taps; ++i)
      values.push_back(Rational(static_cast<int>(random() % 201) - 100) / 3000);
    for (std::size_t i = 2; i < values.size(); ++i) (i % 2 == 0 ? even : odd) += values[i];
    values[0] = 1 - even;
    values[1] = 1 - odd;
    const Smoothness found = analyze_smoothness(Mask(2, 0, values));
    EXPECT_LE(found.hoelder.lower, found.hoelder.upper) << taps;
  }
  const Rational huge = parse_rational("1e400");
  const Smoothness wild = analyze_smoothness(Mask(2, -1, {huge, 1, 1 - huge}));
  EXPECT_EQ(wild.certified, -1);
  const Rational tiny = parse_rational("1e-400");
  const Smoothness near =
      analyze_smoothness(make_scheme("four-point", {{"omega", {Rational(1) / 16 + tiny}}}).mask());
  EXPECT_EQ(near.certified, 1);
  EXPECT_EQ(near.refuted_at, 2);
  // The impulse that is only repeated: a(z) = 1 + z converges to a step, not uniformly.
  EXPECT_EQ(analyze_smoothness(Mask(2, 0, {1, 1})).refuted_at, 0);
}

// One sentence for each way an order is decided, with the numbers that decide it.
TEST(Smoothness, ExplainsWhatDecided) {
  const Smoothness gentle = analyze_smoothness(parse_scheme("gentle").mask());
  EXPECT_EQ(explanation(gentle.orders.at(1)), "the norm of power 2 is 95/128 < 1");
  EXPECT_EQ(explanation(gentle.orders.at(2)), "only 2 sum rules and stable shifts");
  const Smoothness word =
      analyze_smoothness(parse_scheme("three-parameter:a=1/4,c=-19/20,m=2").mask());
  EXPECT_EQ(explanation(word.orders.at(1)), "word 01 has value 1.04773863 >= 1");
  OrderVerdict verdict;
  EXPECT_EQ(explanation(verdict), "neither proved nor refuted");
  verdict.reason = Reason::divergence;
  EXPECT_EQ(explanation(verdict), "a lower order is refuted");
  verdict.reason = Reason::spectral_bound;
  verdict.norm = Rational(1) / 2;
  EXPECT_EQ(explanation(verdict), "the joint spectral radius is at most 0.5 < 1 (scaled)");
}

}  // namespace
}  // namespace arete
