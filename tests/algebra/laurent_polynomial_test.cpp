// SPDX-License-Identifier: MIT
#include "arete/algebra/laurent_polynomial.h"

#include <gtest/gtest.h>

#include "arete/algebra/rational.h"

namespace arete {
namespace {

using P = LaurentPolynomial<Rational>;

TEST(laurent_polynomial, is_trimmed_so_that_equal_polynomials_compare_equal) {
  EXPECT_EQ(P(-2, {0, 0, 3, 0}), P(0, {3}));
  EXPECT_TRUE(P(5, {0, 0}).is_zero());
  EXPECT_EQ(P(5, {0, 0}), P());
}

TEST(laurent_polynomial, ring_laws_hold) {
  const P a(-2, {1, Rational(2, 3), 0, -5});
  const P b(1, {7, 0, Rational(-1, 9)});
  const P c(-4, {3, 3, 3});
  EXPECT_EQ(a * b, b * a);
  EXPECT_EQ(a * (b + c), a * b + a * c);
  EXPECT_EQ((a * b) * c, a * (b * c));
  EXPECT_EQ(a - a, P());
  EXPECT_EQ((a * b).sum(), a.sum() * b.sum());
  EXPECT_EQ((a * b).derivative(), a.derivative() * b + a * b.derivative());
  EXPECT_EQ(a.dilated(3) * b.dilated(3), (a * b).dilated(3));
  EXPECT_EQ(a.shifted(5), a * P::monomial(1, 5));
}

TEST(laurent_polynomial, division_by_the_smoothing_factor_undoes_multiplication_for_every_arity) {
  const P a(-3, {1, Rational(-2, 7), 5, 0, 4});
  for (int m = 2; m <= 9; ++m) {
    const P product = a * smoothing_factor<Rational>(m);
    const auto quotient = product.divided_by_smoothing_factor(m);
    ASSERT_TRUE(quotient.has_value()) << m;
    EXPECT_EQ(*quotient, a);
    // One coefficient off by a thousandth is not divisible any more.
    EXPECT_FALSE((product + P::monomial(Rational(1, 1000), 0)).divided_by_smoothing_factor(m));
  }
  EXPECT_FALSE(P(0, {1}).divided_by_smoothing_factor(2));
}

}  // namespace
}  // namespace arete
