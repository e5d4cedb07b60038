// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "arete/algebra/fraction.h"

namespace arete::family {

/// A scheme made from its difference scheme (Shen and Huang, "A Class of Curve Subdivision Schemes
/// with Several Parameters", equation (2) and theorem 2):
///
///     D(z) = c(z) (1+z)^m,   S(z) = (1+z) D(z),   raised k times: ((1+z)/2)^k S(z)
///
/// with c(z) = sum coefficients[i] z^i, which must sum to 2^-m, and m, raise >= 0.
/// The indices are as in the paper for its schemes (3) (degree 1, m = 1, raise = 1: from -1) and
/// (5) (degree 2, m = 2, raise = 1: from -3), otherwise from -floor(degree/2) where degree is the
/// degree of the whole symbol.
template <class R>
[[nodiscard]] LaurentPolynomial<R> difference(const std::vector<R>& coefficients, int m,
                                              int raise) {
  const LaurentPolynomial<R> half(0, {fraction<R>(1, 2)});
  const auto smoothing = smoothing_factor<R>(2);
  const auto symbol =
      LaurentPolynomial<R>(0, coefficients) * power(smoothing, m + 1 + raise) * power(half, raise);
  const int c_degree = static_cast<int>(coefficients.size()) - 1;
  const int degree = c_degree + m + 1 + raise;
  const bool paper_scheme_3 = c_degree == 1 && m == 1 && raise == 1;
  return symbol.shifted(paper_scheme_3 ? -1 : -(degree / 2));
}

/// c(z) = a z + b, b = 2^-m - a (scheme (3) of the paper for m = 1, raise = 1).
template <class R>
[[nodiscard]] LaurentPolynomial<R> two_parameter(const R& a, int m, int raise) {
  return difference<R>({fraction<R>(1, 1 << m) - a, a}, m, raise);
}

/// c(z) = a z^2 + b z + c, b = 2^-m - a - c (scheme (5) of the paper for m = 2, raise = 1).
template <class R>
[[nodiscard]] LaurentPolynomial<R> three_parameter(const R& a, const R& c, int m, int raise) {
  return difference<R>({c, fraction<R>(1, 1 << m) - a - c, a}, m, raise);
}

/// Scheme (4) of the paper, the asymmetric interpolatory 3-point scheme: p'_{2i} = p_i and
/// p'_{2i+1} = -p_{i-1}/8 + 3 p_i/4 + 3 p_{i+1}/8. C^1, reproduces quadratics, exponent log2(8/3).
template <class R>
[[nodiscard]] LaurentPolynomial<R> three_point() {
  return two_parameter<R>(fraction<R>(-1, 4), 1, 1);
}

}  // namespace arete::family
