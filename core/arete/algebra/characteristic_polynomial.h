// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "arete/algebra/matrix.h"
#include "arete/algebra/rational.h"

namespace arete {

/// det(x I - a) of a square matrix, coefficients ascending (the last one is 1), exact.
///
/// Faddeev and LeVerrier's recursion on the integer matrix (common denominator) * a, where every
/// division is exact. Cost O(n^4) integer products.
[[nodiscard]] inline std::vector<Rational> characteristic_polynomial(const Matrix<Rational>& a) {
  const int n = a.rows();
  Integer scale = 1;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      scale = boost::multiprecision::lcm(scale, boost::multiprecision::denominator(a(i, j)));
  Matrix<Integer> integral(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      integral(i, j) = boost::multiprecision::numerator(a(i, j)) *
                       (scale / boost::multiprecision::denominator(a(i, j)));

  std::vector<Rational> coefficients(static_cast<std::size_t>(n) + 1, Rational(0));
  coefficients.back() = 1;
  Matrix<Integer> adjugate = Matrix<Integer>::identity(n);
  Integer scale_power = 1;
  for (int k = 1; k <= n; ++k) {
    Matrix<Integer> product = integral * adjugate;
    Integer trace = 0;
    for (int i = 0; i < n; ++i) trace += product(i, i);
    const Integer coefficient = -trace / k;
    for (int i = 0; i < n; ++i) product(i, i) += coefficient;
    adjugate = std::move(product);
    scale_power *= scale;
    coefficients[static_cast<std::size_t>(n - k)] = Rational(coefficient) / Rational(scale_power);
  }
  return coefficients;
}

}  // namespace arete
