// SPDX-License-Identifier: MIT
#include "arete/analysis/theorem.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/oracle_scheme.h"
#include "arete/algebra/characteristic_polynomial.h"
#include "arete/analysis/corner_cutting_facts.h"
#include "arete/analysis/difference_theorems.h"
#include "arete/analysis/four_parameter_theorems.h"
#include "arete/analysis/parameter_interval.h"
#include "arete/analysis/polynomial.h"
#include "arete/analysis/ternary_theorem.h"
#include "arete/scheme/catalogue.h"

namespace arete {
namespace {

using test::exact;
using test::exact_list;

TEST(FourParameterTheorems, MeetTheOracle) {
  for (const auto& record : test::parametric_records("p0.theorems")) {
    SCOPED_TRACE(record.at("id").get<std::string>());
    const auto& input = record.at("input");
    const auto& expect = record.at("expect");
    const FourParameterTheorems t =
        four_parameter_theorems(exact(input.at("lambda")), exact(input.at("mu")),
                                exact(input.at("nu")), exact(input.at("omega")));
    EXPECT_EQ(t.theorem1_value, exact(expect.at("thm1")));
    EXPECT_EQ(t.theorem2_value, exact(expect.at("thm2_value")));
    EXPECT_EQ(t.theorem2_residual, exact(expect.at("thm2_residual")));
    EXPECT_EQ(t.theorem3_value, exact(expect.at("thm3_value")));
    EXPECT_EQ(t.theorem3_residuals[0], exact(expect.at("thm3_residuals").at(0)));
    EXPECT_EQ(t.theorem3_residuals[1], exact(expect.at("thm3_residuals").at(1)));
  }
}

// The theorems are the certificate of the first power: wherever they hold, so does that, and back.
TEST(FourParameterTheorems, AreTheFirstPower) {
  for (int l = -2; l <= 6; ++l)
    for (int w = -3; w <= 3; ++w)
      for (const char* balance : {"1/4", "1/2", "1"}) {
        const Rational lambda = Rational(l) / 16;
        const Rational omega = Rational(w) / 32;
        const Rational nu = parse_rational(balance);
        const Rational mu = lambda + 4 * omega * (2 * nu - 1);
        const auto results = four_parameter_results(lambda, mu, nu, omega);
        const Mask mask =
            make_scheme("four-parameter",
                        {{"lambda", {lambda}}, {"mu", {mu}}, {"nu", {nu}}, {"omega", {omega}}})
                .mask();
        for (int order = 0; order < 3; ++order) {
          const auto norm = contractivity_norm(mask, order, 1);
          EXPECT_EQ(results[static_cast<std::size_t>(order)].holds, norm && *norm < 1);
        }
      }
}

TEST(DifferenceTheorems, MeetTheOracle) {
  for (const auto& record : test::parametric_records("p1.theorem4")) {
    SCOPED_TRACE(record.at("id").get<std::string>());
    const auto& input = record.at("input");
    const auto& expect = record.at("expect");
    const std::vector<Rational> coefficients = {exact(input.at("c")), exact(input.at("b")),
                                                exact(input.at("a"))};
    const TheoremResult printed = difference_theorem(coefficients);
    EXPECT_EQ(printed.holds, expect.at("printed_condition").get<bool>());
    EXPECT_FALSE(printed.sound);
    const DifferenceConvergence truth = difference_convergence(coefficients);
    EXPECT_EQ(truth.verdict,
              expect.at("convergent").get<bool>() ? Verdict::certified : Verdict::refuted);
    std::vector<std::string> violated;
    for (const Word& word : truth.violated) violated.push_back(to_text(word));
    EXPECT_EQ(violated, expect.at("violated_words").get<std::vector<std::string>>());
    EXPECT_EQ(truth.norm1, exact(expect.at("L1_norm")));
    EXPECT_EQ(truth.norm2, exact(expect.at("L2_norm")));
    // The record's bound is over short words; ours may be better, never worse.
    const double lower = expect.at("jsr_lower_bound").get<double>();
    EXPECT_GE(to_double(truth.jsr.lower), lower - 1e-9);
    EXPECT_GE(to_double(truth.jsr.upper), lower - 1e-9);
  }
}

TEST(DifferenceTheorems, Property1HasTheCounterexampleOfTheOracle) {
  for (const auto& record : test::parametric_records("p1.property1")) {
    const auto& input = record.at("input");
    const auto& expect = record.at("expect");
    const auto first = exact_list(input.at("D1_cba"));
    const auto second = exact_list(input.at("D2_cba"));
    EXPECT_TRUE(mixture_property(first, second).holds);
    EXPECT_FALSE(mixture_property(first, second).sound);
    EXPECT_EQ(difference_convergence(first).verdict, Verdict::certified);
    EXPECT_EQ(difference_convergence(second).verdict, Verdict::certified);
    const auto mixed = mixture(first, second, exact(input.at("alpha")));
    EXPECT_EQ(mixed, exact_list(expect.at("mix_cba")));
    const DifferenceConvergence truth = difference_convergence(mixed);
    EXPECT_EQ(truth.verdict, Verdict::refuted);
    EXPECT_EQ(to_text(truth.jsr.word), expect.at("word").get<std::string>());
    EXPECT_NEAR(to_double(truth.jsr.lower), expect.at("mix_value").get<double>(), 1e-9);
    auto characteristic = characteristic_polynomial(
        word_product(local_matrices(2, LaurentPolynomial<Rational>(0, mixed)), {0, 1}));
    std::reverse(characteristic.begin(), characteristic.end());
    EXPECT_EQ(characteristic, exact_list(expect.at("mix_word_charpoly")));
  }
}

// Theorem 3 is true: convergent exactly for |a|, |b| < 1.
TEST(DifferenceTheorems, Theorem3IsTheTruth) {
  for (int i = -24; i <= 24; ++i) {
    const Rational a = Rational(i) / 16;
    const std::vector<Rational> coefficients = {Rational(1) / 2 - a, a};
    EXPECT_EQ(difference_convergence(coefficients).verdict,
              difference_theorem(coefficients).holds ? Verdict::certified : Verdict::refuted)
        << to_string(a);
  }
}

TEST(Theorems, AreComparedWithTheTruth) {
  const auto comparisons = [](const char* text) {
    const Scheme scheme = parse_scheme(text);
    const Smoothness truth = analyze_smoothness(scheme.mask());
    std::vector<Comparison> all;
    for (const TheoremResult& theorem : theorems_for(scheme))
      all.push_back(compare(theorem, truth));
    return all;
  };
  using enum Comparison;
  EXPECT_EQ(comparisons("four-point"), (std::vector{confirmed, too_weak, silent}));
  EXPECT_EQ(comparisons("gentle"), (std::vector{confirmed, too_weak, silent}));
  EXPECT_EQ(comparisons("craggy"), (std::vector{too_weak, silent, silent}));
  EXPECT_EQ(comparisons("four-parameter-c2"), (std::vector{confirmed, confirmed, confirmed}));
  // Theorem 4 promises C^1 here; word 01 refutes it.
  EXPECT_EQ(comparisons("three-parameter:a=1/4,c=-19/20,m=2,raise=1").front(), contradicted);
  EXPECT_EQ(comparisons("ternary-two-step:b=0.6"), (std::vector{confirmed, confirmed, too_weak}));
  // Every statement that is true is never contradicted, on all of the catalogue's defaults.
  for (const Family& family : catalogue()) {
    if (family.name == "mask" || family.name == "difference") continue;
    const Scheme scheme = make_scheme(family.name);
    const Smoothness truth = analyze_smoothness(scheme.mask());
    for (const TheoremResult& theorem : theorems_for(scheme))
      if (theorem.sound) {
        EXPECT_NE(compare(theorem, truth), contradicted) << family.name << " " << theorem.name;
      }
  }
}

TEST(CornerCutting, HasTheSpectraOfTheOracle) {
  for (const auto& record : test::ternary_and_reverse_records("r.LR_uv")) {
    SCOPED_TRACE(record.at("id").get<std::string>());
    const Rational u = exact(record.at("input").at("u"));
    const Rational v = exact(record.at("input").at("v"));
    const auto& expect = record.at("expect");
    const auto descending = [](const Matrix<Rational>& matrix) {
      auto p = characteristic_polynomial(matrix);
      std::reverse(p.begin(), p.end());
      return p;
    };
    EXPECT_EQ(descending(corner_cutting_left(u, v)), exact_list(expect.at("charpoly_L")));
    EXPECT_EQ(descending(corner_cutting_right(u, v)), exact_list(expect.at("charpoly_R")));
    const CornerCuttingFacts facts = corner_cutting_facts(u, v);
    auto left = exact_list(expect.at("eigenvalues_L"));
    std::vector<Rational> ours(facts.left_spectrum.begin(), facts.left_spectrum.end());
    std::sort(left.begin(), left.end());
    std::sort(ours.begin(), ours.end());
    EXPECT_EQ(ours, left);
    EXPECT_EQ(facts.smooth_parameter, expect.at("parametric_C1").get<bool>());
    EXPECT_EQ(facts.smooth_tangent, expect.at("tangent_continuous").get<bool>());
  }
  // Geometric smoothness is not parametric smoothness.
  const CornerCuttingFacts de_rham = corner_cutting_facts(Rational(1) / 3, Rational(1) / 3);
  EXPECT_TRUE(de_rham.smooth_tangent);
  EXPECT_EQ(analyze_smoothness(make_scheme("de-rham").mask()).refuted_at, 1);
}

Mask ternary(const Rational& b) { return make_scheme("ternary-two-step", {{"b", {b}}}).mask(); }

TEST(TernaryTheorem, HasItsPrintedIntervalsExactly) {
  for (const auto& record : test::ternary_and_reverse_records("t.theorem_3_1")) {
    SCOPED_TRACE(record.at("id").get<std::string>());
    const auto& expect = record.at("expect");
    const int order = record.at("input").at("continuity").get<int>();
    const TernaryInterval& interval = ternary_intervals()[static_cast<std::size_t>(order)];
    const auto check = [&](const char* end, const Rational& printed,
                           const std::array<int, 3>& root_of) {
      const auto highest_first =
          expect.at(std::string(end) + "_is_root_of").get<std::vector<int>>();
      EXPECT_EQ(std::vector<int>(root_of.rbegin(), root_of.rend()), highest_first);
      const Rational value(expect.at(end).get<double>());
      EXPECT_LT(abs(value - printed), parse_rational("1e-3"));
      // The polynomial changes sign within 1e-12, and the norm crosses 1 there.
      const auto polynomial = [&root_of](const Rational& b) {
        return root_of[0] + b * (root_of[1] + b * root_of[2]);
      };
      const Rational less = value - parse_rational("1e-12");
      const Rational more = value + parse_rational("1e-12");
      EXPECT_LT(polynomial(less) * polynomial(more), 0);
      const bool rising = std::string(end) == "upper";
      EXPECT_EQ(ternary_results(less)[static_cast<std::size_t>(order)].holds, rising);
      EXPECT_EQ(ternary_results(more)[static_cast<std::size_t>(order)].holds, !rising);
    };
    check("lower", interval.printed_lower, interval.lower_root_of);
    check("upper", interval.printed_upper, interval.upper_root_of);
  }
}

TEST(TernaryTheorem, LargerPowersCertifyTheIntervalsOfTheOracle) {
  for (const auto& record : test::ternary_and_reverse_records("t.power_L_interval")) {
    const int power = record.at("input").at("power").get<int>();
    if (power > 4) continue;  // the ends of the larger powers are only checked, below
    for (int order = 0; order < 3; ++order) {
      SCOPED_TRACE("L = " + std::to_string(power) + ", C^" + std::to_string(order));
      const auto& expect = record.at("expect").at("C" + std::to_string(order));
      const auto interval = interval_where(
          [&](const Rational& b) { return *contractivity_norm(ternary(b), order, power) < 1; },
          {Rational(1) / 20, Rational(1) / 4, 40, parse_rational("1e-10")});
      ASSERT_EQ(interval.has_value(), !expect.is_null());
      if (!interval) continue;
      EXPECT_NEAR(to_double(interval->lower), expect.at(0).get<double>(), 1e-9);
      EXPECT_NEAR(to_double(interval->upper), expect.at(1).get<double>(), 1e-9);
    }
  }
}

TEST(TernaryTheorem, LargestPowersCrossOneAtTheEndsOfTheOracle) {
  for (const auto& record : test::ternary_and_reverse_records("t.power_L_interval")) {
    const int power = record.at("input").at("power").get<int>();
    if (power <= 4) continue;
    for (int order = 0; order < 3; ++order) {
      const auto& expect = record.at("expect").at("C" + std::to_string(order));
      for (int end = 0; end < 2; ++end) {
        SCOPED_TRACE("L = " + std::to_string(power) + ", C^" + std::to_string(order));
        const Rational at(expect.at(static_cast<std::size_t>(end)).get<double>());
        const Rational out = at + (end == 0 ? -1 : 1) * parse_rational("1e-9");
        const Rational in = at - (end == 0 ? -1 : 1) * parse_rational("1e-9");
        EXPECT_LT(*contractivity_norm(ternary(in), order, power), 1);
        EXPECT_GE(*contractivity_norm(ternary(out), order, power), 1);
      }
    }
  }
}

// The sharp ends: refuted by an exact word just outside, certified (by a polytope) just inside.
TEST(TernaryTheorem, IsSharpWhereTheOracleSays) {
  const std::vector<Word> words = {{0}, {1}, {2}, {0, 1}, {0, 2}, {1, 2}};
  for (const auto& record : test::ternary_and_reverse_records("t.sharp_interval")) {
    SCOPED_TRACE(record.at("id").get<std::string>());
    const int order = record.at("input").at("continuity").get<int>();
    const Rational bound = Rational(1) / power(Rational(3), static_cast<unsigned>(order));
    const auto not_refuted = [&](const Rational& b) {
      const LocalMatrices local = local_matrices(3, factored(ternary(b)).rest);
      for (const Word& word : words)
        if (word_reaches(local, word, bound)) return false;
      return true;
    };
    // At b = 1/6 there are four sum rules; start elsewhere.
    const auto interval = interval_where(
        not_refuted, {Rational(1) / 20, Rational(1) / 10, 40, parse_rational("1e-10")});
    ASSERT_TRUE(interval.has_value());
    EXPECT_NEAR(to_double(interval->lower), record.at("expect").at("lower").get<double>(), 1e-8);
    EXPECT_NEAR(to_double(interval->upper), record.at("expect").at("upper").get<double>(), 1e-8);
    EXPECT_EQ(analyze_smoothness(ternary(interval->fails_below)).refuted_at, order);
    EXPECT_EQ(analyze_smoothness(ternary(interval->fails_above)).refuted_at, order);
    // At the upper end of C^1 the leading eigenvalues are a complex pair: no polytope is tight.
    const Rational inside = Rational(1) / 1000;
    const Rational upper_inside = order == 1 ? 10 * inside : inside;
    EXPECT_EQ(analyze_smoothness(ternary(interval->lower + inside)).certified, order);
    EXPECT_EQ(analyze_smoothness(ternary(interval->upper - upper_inside)).certified, order);
  }
}

// C^3 is impossible for every b: it needs four sum rules, which only b = 1/6 has.
TEST(TernaryTheorem, C3IsRefutedForEveryParameter) {
  for (const auto& record : test::ternary_and_reverse_records("t.c3")) {
    const auto& expect = record.at("expect");
    const Smoothness best = analyze_smoothness(ternary(exact(record.at("input").at("b"))));
    EXPECT_EQ(best.hoelder.sum_rules, expect.at("sum_rules").get<int>());
    EXPECT_EQ(best.refuted_at, 3);
    EXPECT_EQ(best.orders[3].reason, Reason::word);
    EXPECT_NEAR(best.hoelder.lower, expect.at("alpha").get<double>(), 1e-8);
  }
  // q(z) = a/(1+z+z^2)^3 modulo 1+z+z^2 is affine in b, so its one zero at 1/6 is the only one.
  const auto remainder = [](const Rational& b) {
    LaurentPolynomial<Rational> q = ternary(b).symbol();
    for (int i = 0; i < 3; ++i) q = *q.divided_by_smoothing_factor(3);
    std::array<Rational, 3> sums{};  // by residue modulo 3; differences are the remainder
    for (int k = q.lowest(); k <= q.highest(); ++k)
      sums[static_cast<std::size_t>(((k % 3) + 3) % 3)] += q[k];
    return std::pair<Rational, Rational>(sums[0] - sums[2], sums[1] - sums[2]);
  };
  const auto at = [&remainder](const Rational& b) { return remainder(b); };
  const auto [c0, c1] = at(0);
  const auto [d0, d1] = at(1);
  for (const char* b : {"-7", "2/3", "19"}) {
    const Rational x = parse_rational(b);
    EXPECT_EQ(at(x).first, c0 + x * (d0 - c0));
    EXPECT_EQ(at(x).second, c1 + x * (d1 - c1));
  }
  EXPECT_TRUE(c0 != d0 || c1 != d1);
  EXPECT_EQ(at(Rational(1) / 6), (std::pair<Rational, Rational>(0, 0)));
  for (const char* b : {"0", "0.1", "0.1666", "1/3"}) {
    const Smoothness other = analyze_smoothness(ternary(parse_rational(b)));
    EXPECT_EQ(other.hoelder.sum_rules, 3) << b;
    EXPECT_EQ(other.refuted_at, 3) << b;
    EXPECT_EQ(other.orders[3].reason, Reason::sum_rules) << b;
  }
}

TEST(Theorems, TheMarginOfARegionIsNegativeInsideAndZeroOnItsRim) {
  const auto margin = [](const char* scheme) {
    return region_margin(theorems_for(parse_scheme(scheme)).front());
  };
  const auto inside = margin("corner-cutting:u=1/4,v=1/4");
  const auto rim = margin("corner-cutting:u=1/2,v=1/2");
  const auto outside = margin("corner-cutting:u=3/4,v=1/2");
  ASSERT_TRUE(inside && rim && outside);
  EXPECT_LT(*inside, 0);
  EXPECT_EQ(*rim, 0);
  EXPECT_GT(*outside, 0);
  EXPECT_FALSE(region_margin(TheoremResult{}).has_value());
}

// (a, b, c) = (6/25, ., -24/25), m = 3: the mean of two convergent difference schemes that is not
// convergent; a scheme that is convergent refutes nothing.
TEST(Theorems, AMixtureThatDoesNotConvergeNamesItsParts) {
  const auto refuted = property_1_refuted_by(parse_scheme("three-parameter:a=6/25,c=-24/25,m=3"));
  ASSERT_TRUE(refuted.has_value());
  EXPECT_FALSE(refuted->sound);
  EXPECT_NE(refuted->remark.find("both proved convergent"), std::string::npos) << refuted->remark;
  EXPECT_FALSE(property_1_refuted_by(parse_scheme("three-parameter:a=1/12,c=1/12")).has_value());
  EXPECT_FALSE(property_1_refuted_by(parse_scheme("four-point")).has_value());
}

}  // namespace
}  // namespace arete
