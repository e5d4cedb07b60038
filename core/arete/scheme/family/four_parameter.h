// SPDX-License-Identifier: MIT
#pragma once

#include "arete/algebra/fraction.h"

namespace arete::family {

/// The four-parameter 4-point scheme of Zhao, Peng and Ye ("Improved Four Points Subdivision
/// Scheme and its Applications", rule (1)). With d_i = p_i - [nu p_{i-1} + (1-nu) p_{i+1}]:
///
///     p'_{2i}   = lambda p_{i-1} + (1-lambda-mu) p_i + mu p_{i+1}
///     p'_{2i+1} = (p_i + p_{i+1})/2 + 2 omega (d_i + d_{i+1})
///
/// Its mask stands on -3..3. The mirror image is (mu, lambda, 1-nu, omega). Two sum rules hold on
/// the plane mu - lambda = 4 omega (2 nu - 1), three on the family `four_parameter_c2`.
template <class R>
[[nodiscard]] LaurentPolynomial<R> four_parameter(const R& lambda, const R& mu, const R& nu,
                                                  const R& omega) {
  const R half = fraction<R>(1, 2);
  const R left = R(2) * omega * nu;            // 2 omega nu
  const R right = R(2) * omega * (R(1) - nu);  // 2 omega (1 - nu)
  const R centre = R(1) - lambda - mu;
  return LaurentPolynomial<R>(
      -3, {R(0) - right, mu, half + left, centre, half + right, lambda, R(0) - left});
}

/// The C^2 family inside it (both equalities of the paper's theorem 3 solved):
/// lambda = 1/8 - 4 omega nu, mu = 1/8 - 4 omega (1-nu). For 0 <= nu <= 1, omega >= 0 the critical
/// Hoelder exponent is -log2(1/8 + 2 omega): C^2 iff omega < 1/16, C^1 iff omega < 3/16.
template <class R>
[[nodiscard]] LaurentPolynomial<R> four_parameter_c2(const R& nu, const R& omega) {
  const R eighth = fraction<R>(1, 8);
  return four_parameter<R>(eighth - R(4) * omega * nu, eighth - R(4) * omega * (R(1) - nu), nu,
                           omega);
}

/// The classic interpolatory 4-point scheme (Dyn, Gregory, Levin 1987): lambda = mu = 0, nu = 1/2.
template <class R>
[[nodiscard]] LaurentPolynomial<R> four_point(const R& omega) {
  return four_parameter<R>(R(0), R(0), fraction<R>(1, 2), omega);
}

/// Example 1 of the paper, a gentle landscape: C^1, Hoelder exponent log2(16/5) = 1.678.
template <class R>
[[nodiscard]] LaurentPolynomial<R> gentle() {
  return four_parameter<R>(fraction<R>(7, 32), fraction<R>(7, 32), fraction<R>(1, 2),
                           fraction<R>(3, 64));
}

/// Example 2 of the paper, a craggy landscape: C^0, Hoelder exponent log2(10/7) = 0.515.
template <class R>
[[nodiscard]] LaurentPolynomial<R> craggy() {
  return four_parameter<R>(fraction<R>(1, 30), fraction<R>(1, 30), fraction<R>(1, 2),
                           fraction<R>(1, 3));
}

}  // namespace arete::family
