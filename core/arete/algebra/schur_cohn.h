// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "arete/algebra/characteristic_polynomial.h"
#include "arete/algebra/rational.h"

namespace arete {

/// Whether every root of the polynomial (coefficients ascending, not all zero) lies in the open
/// unit disc |z| < 1. Exact: Schur and Cohn's recursion p -> (p_n p - p_0 p*)/z, where p* has the
/// coefficients of p in reverse; p is stable iff |p_0| < |p_n| and the next one is. A constant has
/// no roots and is stable. On integers, every result from the third on is divisible by the leading
/// coefficient before the last (Jury's modified table), so that the numbers grow only linearly.
/// Cost O(n^2) products.
[[nodiscard]] inline bool is_schur_stable(const std::vector<Rational>& polynomial) {
  Integer scale = 1;
  for (const Rational& c : polynomial)
    scale = boost::multiprecision::lcm(scale, boost::multiprecision::denominator(c));
  std::vector<Integer> p;
  for (const Rational& c : polynomial)
    p.push_back(boost::multiprecision::numerator(c) *
                (scale / boost::multiprecision::denominator(c)));
  while (!p.empty() && p.back() == 0) p.pop_back();
  Integer content = 0;
  for (const Integer& c : p) content = boost::multiprecision::gcd(content, c);
  for (Integer& c : p) c /= content;

  Integer divisor = 1;
  for (bool first = true; p.size() > 1; first = false) {
    const std::size_t degree = p.size() - 1;
    if (abs(p.front()) >= abs(p.back())) return false;
    std::vector<Integer> next(degree, Integer(0));
    for (std::size_t i = 0; i < degree; ++i)
      next[i] = (p.back() * p[i + 1] - p.front() * p[degree - i - 1]) / divisor;
    divisor = first ? Integer(1) : p.back();
    p = std::move(next);
  }
  return true;
}

/// Whether the spectral radius of a square rational matrix is at least `bound` >= 0. Exact, and
/// right in the case of equality.
[[nodiscard]] inline bool spectral_radius_at_least(const Matrix<Rational>& a,
                                                   const Rational& bound) {
  if (bound == 0) return true;
  std::vector<Rational> scaled = characteristic_polynomial(a);
  Rational factor = 1;
  for (Rational& coefficient : scaled) {
    coefficient *= factor;
    factor *= bound;
  }
  return !is_schur_stable(std::move(scaled));
}

}  // namespace arete
