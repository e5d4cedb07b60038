// SPDX-License-Identifier: MIT
#include "arete/analysis/joint_spectral_radius.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "analysis/oracle_scheme.h"
#include "arete/analysis/hoelder.h"
#include "support/markdown_table.h"

namespace arete {
namespace {

using test::exact;

TEST(Hoelder, MeetsTheParametricOracle) {
  for (const auto& record : test::parametric_records("hoelder")) {
    SCOPED_TRACE(record.at("id").get<std::string>());
    const Mask mask = test::mask_of(record.at("input"));
    const auto& expect = record.at("expect");
    const HoelderBounds bounds = hoelder_bounds(mask);
    EXPECT_EQ(bounds.sum_rules, expect.at("N").get<int>());
    EXPECT_EQ(factored(mask).rest.coefficients(), test::exact_list(expect.at("q_N")));
    EXPECT_NEAR(bounds.lower, expect.at("alpha").at(0).get<double>(), 1e-6);
    EXPECT_NEAR(bounds.upper, expect.at("alpha").at(1).get<double>(), 1e-6);
    EXPECT_LE(bounds.lower, bounds.upper);
    EXPECT_TRUE(bounds.jsr.closed());
    EXPECT_NEAR(to_double(bounds.jsr.lower), expect.at("jsr").at(0).get<double>(), 1e-9);
    EXPECT_EQ(to_text(bounds.jsr.word), expect.at("word").get<std::string>());
    EXPECT_EQ(bounds.stability, Stability::stable);
    const bool says_not_attained =
        expect.at("formula").get<std::string>().find("not attained") != std::string::npos;
    EXPECT_EQ(bounds.attained, says_not_attained ? Attained::no : Attained::yes);
  }
}

TEST(Hoelder, MeetsTheTernaryOracle) {
  for (const auto& record : test::ternary_and_reverse_records("t.hoelder")) {
    if (!record.at("input").contains("b")) continue;
    SCOPED_TRACE(record.at("id").get<std::string>());
    const HoelderBounds bounds = hoelder_bounds(test::ternary_mask(record.at("input")));
    const double alpha = record.at("expect").at("alpha").get<double>();
    EXPECT_NEAR(bounds.lower, alpha, 5e-8);
    EXPECT_NEAR(bounds.upper, alpha, 5e-8);
    // The order that the exponent proves.
    EXPECT_EQ(static_cast<int>(std::ceil(bounds.lower)) - 1,
              record.at("expect").at("certified_C").get<int>());
    EXPECT_EQ(static_cast<int>(bounds.jsr.word.size()) %
                  record.at("expect").at("smp_word_length").get<int>(),
              0);
  }
}

TEST(Hoelder, OfTheTernarySchemeIsLargestWhereTheOracleSays) {
  for (const auto& record : test::ternary_and_reverse_records("t.hoelder")) {
    if (record.at("input").contains("b")) continue;
    const Rational best(record.at("expect").at("b_star").get<double>());
    // The stationary point is where the closed forms of the words 02 and 0 meet: a root of this.
    const auto root_of = test::exact_list(record.at("expect").at("b_star_is_root_of"));
    const auto polynomial = [&root_of](const Rational& b) {
      Rational value = 0;
      for (const Rational& c : root_of) value = value * b + c;  // highest first
      return value;
    };
    const Rational near = parse_rational("1e-12");
    EXPECT_LT(polynomial(best - near) * polynomial(best + near), 0);
    const auto alpha = [](const Rational& b) {
      return hoelder_bounds(make_scheme("ternary-two-step", {{"b", {b}}}).mask());
    };
    // Two products that are no mirror images lead together here, so the bounds only come close.
    EXPECT_NEAR(alpha(best).lower, record.at("expect").at("alpha_star").get<double>(), 1e-6);
    EXPECT_NEAR(alpha(best).upper, record.at("expect").at("alpha_star").get<double>(), 1e-9);
    for (const char* away : {"-1/100", "-1/10000", "1/10000", "1/100"})
      EXPECT_LT(alpha(best + parse_rational(away)).upper, alpha(best).lower) << away;
  }
}

TEST(Hoelder, OfCornerCutting) {
  for (const auto& record : test::ternary_and_reverse_records("r.uv_jsr")) {
    SCOPED_TRACE(record.at("id").get<std::string>());
    const auto& input = record.at("input");
    const Mask mask = make_scheme("corner-cutting",
                                  {{"u", {exact(input.at("u"))}}, {"v", {exact(input.at("v"))}}})
                          .mask();
    const HoelderBounds bounds = hoelder_bounds(mask);
    const double jsr = record.at("expect").at("jsr_of_difference_matrices").get<double>();
    const double alpha = record.at("expect").at("hoelder_exponent_dyadic_parameter").get<double>();
    EXPECT_NEAR(to_double(bounds.jsr.lower), jsr, 1e-9);
    EXPECT_NEAR(to_double(bounds.jsr.upper), jsr, 1e-9);
    EXPECT_NEAR(bounds.lower, alpha, 1e-9);
    EXPECT_NEAR(bounds.upper, alpha, 1e-9);
  }
}

// The two-step scheme's JSR is the square, here a rational: proved equal by an exact polytope.
TEST(JointSpectralRadius, HasTheClosedFormOfTheTernaryScheme) {
  for (const auto& record : test::ternary_and_reverse_records("t.jsr_closed_form")) {
    SCOPED_TRACE(record.at("id").get<std::string>());
    const Rational b = exact(record.at("input").at("b"));
    const Rational squared = exact(record.at("expect").at("jsr_squared"));
    EXPECT_EQ(squared, (459 + 1020 * b - 32 * b * b) / 93312);
    const FactoredMask two_steps = factored(make_scheme("ternary-two-step-9", {{"b", {b}}}).mask());
    const JsrBounds bounds = joint_spectral_radius(9, two_steps.rest);
    EXPECT_EQ(bounds.exact, squared);
    EXPECT_TRUE(bounds.bounded);
  }
  for (const auto& record : test::ternary_and_reverse_records("t.jsr_cubic")) {
    SCOPED_TRACE(record.at("id").get<std::string>());
    const JsrBounds bounds = hoelder_bounds(test::ternary_mask(record.at("input"))).jsr;
    EXPECT_NEAR(to_double(bounds.lower), record.at("expect").at("jsr").get<double>(), 1e-11);
    EXPECT_NEAR(to_double(bounds.upper), record.at("expect").at("jsr").get<double>(), 1e-11);
    const auto cubic = test::exact_list(record.at("expect").at("cubic_highest_first"));
    const auto value = [&cubic](const Rational& x) {
      return ((cubic[0] * x + cubic[1]) * x + cubic[2]) * x + cubic[3];
    };
    // The root (or its negative) lies between the proved bounds.
    const bool positive = value(bounds.lower * (1 - parse_rational("1e-12"))) *
                              value(bounds.upper * (1 + parse_rational("1e-12"))) <=
                          0;
    const bool negative = value(-bounds.lower * (1 - parse_rational("1e-12"))) *
                              value(-bounds.upper * (1 + parse_rational("1e-12"))) <=
                          0;
    EXPECT_TRUE(positive || negative);
  }
}

// Exponents of Daubechies' scaling functions D_{2N}: published by several authors (e.g. Guglielmi,
// Protasov 2013, table of alpha for N = 2..20). The symbols are factored here from the definition:
// |q(e^{i xi})|^2 = P(sin^2(xi/2)), P(y) = sum_k binomial(N-1+k, k) y^k.
LaurentPolynomial<Rational> daubechies_rest(int n) {
  using C = std::complex<double>;
  std::vector<double> p = {1};
  for (int k = 1; k < n; ++k) p.push_back(p.back() * (n - 1 + k) / k);
  std::vector<C> roots;  // Durand and Kerner
  for (int i = 0; i + 1 < n; ++i) roots.push_back(std::pow(C(0.4, 0.9), i));
  for (int step = 0; step < 2000; ++step)
    for (std::size_t i = 0; i < roots.size(); ++i) {
      C value = 0;
      for (auto c = p.rbegin(); c != p.rend(); ++c) value = value * roots[i] + *c;
      C others = p.back();
      for (std::size_t j = 0; j < roots.size(); ++j)
        if (j != i) others *= roots[i] - roots[j];
      roots[i] -= value / others;
    }
  std::vector<C> q = {1};
  for (const C& y : roots) {
    const C half = C(1) - 2.0 * y;  // z + 1/z = 2 - 4 y
    C z = half + std::sqrt(half * half - C(1));
    if (std::abs(z) > 1) z = C(1) / z;
    std::vector<C> next(q.size() + 1);
    for (std::size_t i = 0; i < q.size(); ++i) {
      next[i + 1] += q[i];
      next[i] -= z * q[i];
    }
    q = std::move(next);
  }
  double sum = 0;
  for (const C& c : q) sum += c.real();
  std::vector<Rational> coefficients;
  for (const C& c : q) coefficients.emplace_back(c.real() / sum * std::ldexp(2.0, -n));
  return {0, coefficients};
}

TEST(JointSpectralRadius, GivesTheExponentsOfDaubechies) {
  const auto rows = test::markdown_table("docs/smoothness.md", "Daubechies");
  EXPECT_EQ(rows.size(), 9u);
  for (const auto& row : rows) {
    const int n = std::stoi(row.at(0));
    SCOPED_TRACE(n);
    const double published = std::stod(row.at(1));
    const double shown = std::stod(row.at(2));
    const JsrBounds bounds = joint_spectral_radius(2, daubechies_rest(n));
    if (n < 10) {
      EXPECT_TRUE(bounds.closed());
    }
    for (const Rational& bound : {bounds.lower, bounds.upper}) {
      EXPECT_NEAR(negative_log(bound, 2), published, 1.1e-4);
      EXPECT_NEAR(negative_log(bound, 2), shown, n < 10 ? 5.1e-7 : 2e-5);
    }
  }
  // The two that are known in closed form (Daubechies, Lagarias 1992): 2 - log2(1 + sqrt 3), and
  // 3 - log2 |...| of D6 numerically.
  EXPECT_NEAR(std::stod(rows[0].at(2)), 2 - std::log2(1 + std::sqrt(3.0)), 5.1e-7);
}

TEST(JointSpectralRadius, OfPublishedSchemes) {
  const auto alpha = [](const Mask& mask) {
    const HoelderBounds bounds = hoelder_bounds(mask);
    EXPECT_NEAR(bounds.lower, bounds.upper, 1e-9);
    return bounds.lower;
  };
  EXPECT_NEAR(alpha(make_scheme("dubuc-deslauriers", {{"points", {6}}}).mask()), 2.830075, 1e-6);
  EXPECT_NEAR(alpha(make_scheme("ternary-four-point").mask()), 2.182658, 1e-6);
  for (int degree = 1; degree < 20; ++degree)
    EXPECT_EQ(alpha(make_scheme("b-spline", {{"degree", {degree}}}).mask()), degree);
}

// JSR of a power is the power of the JSR; rescaling the mask of differences rescales it.
TEST(JointSpectralRadius, IsHomogeneousAndMultiplicative) {
  const auto q = factored(make_scheme("gentle").mask()).rest;
  const JsrBounds one = joint_spectral_radius(2, q);
  const JsrBounds scaled = joint_spectral_radius(2, q.scaled(Rational(-3) / 7));
  const JsrBounds squared = joint_spectral_radius(4, q * q.dilated(2));
  ASSERT_TRUE(one.exact && scaled.exact && squared.exact);
  EXPECT_EQ(*one.exact, Rational(5) / 16);
  EXPECT_EQ(*scaled.exact, *one.exact * 3 / 7);
  EXPECT_EQ(*squared.exact, *one.exact * *one.exact);
}

// Degenerate operators: nilpotent ones have the JSR 0, single coefficients themselves.
TEST(JointSpectralRadius, OfDegenerateOperators) {
  using Laurent = LaurentPolynomial<Rational>;
  const JsrBounds single = joint_spectral_radius(3, Laurent(7, {Rational(-2) / 3}));
  EXPECT_EQ(single.exact, Rational(2) / 3);
  const JsrBounds difference = joint_spectral_radius(2, Laurent(0, {1, -1}));
  EXPECT_EQ(difference.exact, 1);  // ||S|| = 1 and single entries stay
  const JsrBounds wide = joint_spectral_radius(64, Laurent(0, {1, 0, Rational(1) / 2}));
  EXPECT_EQ(wide.exact, 1);
}

// JSR(q) = max(|q(1)|/m, JSR(q/(1 + ... + z^{m-1}))).
TEST(JointSpectralRadius, SplitsAlongSmoothingFactors) {
  for (const char* name : {"craggy", "ternary-two-step", "de-rham"}) {
    const Mask mask = make_scheme(name).mask();
    const FactoredMask parts = factored(mask);
    const auto more = parts.rest * smoothing_factor<Rational>(mask.arity());
    const JsrBounds rest = joint_spectral_radius(mask.arity(), parts.rest);
    const JsrBounds whole = joint_spectral_radius(mask.arity(), more);
    const double scalar = std::abs(to_double(more.sum())) / mask.arity();
    EXPECT_GE(to_double(whole.upper), std::max(scalar, to_double(rest.lower)) * (1 - 1e-12));
    EXPECT_LE(to_double(whole.lower), std::max(scalar, to_double(rest.upper)) * (1 + 1e-12));
  }
}

// Rounding in the search cannot make a bound wrong: the exact test of the lower one and an exact
// norm from above always agree with them.
TEST(JointSpectralRadius, BoundsAreProvedExactly) {
  for (const char* b : {"-7/5", "-1/10", "1/20", "1", "6/5", "3"}) {
    const auto q =
        factored(make_scheme("ternary-two-step", {{"b", {parse_rational(b)}}}).mask()).rest;
    const JsrBounds bounds = joint_spectral_radius(3, q);
    EXPECT_TRUE(word_reaches(local_matrices(3, q), bounds.word, bounds.lower)) << b;
    EXPECT_FALSE(word_reaches(local_matrices(3, q), bounds.word,
                              bounds.upper * (1 + parse_rational("1e-12"))))
        << b;
    EXPECT_LE(bounds.lower, bounds.upper);
  }
}

}  // namespace
}  // namespace arete
