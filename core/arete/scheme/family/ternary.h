// SPDX-License-Identifier: MIT
#pragma once

#include "arete/algebra/fraction.h"

namespace arete::family {

/// One step of the ternary scheme whose square interpolates (Zhong and Qi, "Parameterized ternary
/// two-step interpolatory subdivision scheme", equation (3.1)), parameter b = b_{-1}; mask on -6..7
/// (a_i = a_{1-i}), dual (tau = 1/2), three sum rules for every b and four at b = 1/6:
///
///     p'_{3i}   = a_6 p_{i-2} + a_3 p_{i-1} + a_0 p_i + a_-3 p_{i+1} + a_-6 p_{i+2}
///     p'_{3i+1} = its mirror image,   p'_{3i+2} = (-p_{i-1} + 9 p_i + 9 p_{i+1} - p_{i+2})/16
template <class R>
[[nodiscard]] LaurentPolynomial<R> ternary_two_step(const R& b) {
  const R a1 = fraction<R>(137, 144);
  const R a2 = fraction<R>(9, 16);
  const R a3 = b * fraction<R>(1, 27) + fraction<R>(19, 144);
  const R a4 = R(0) - b * fraction<R>(1, 27) - fraction<R>(11, 144);
  const R a5 = fraction<R>(-1, 16);
  const R a6 = R(0) - b * fraction<R>(1, 54) - fraction<R>(1, 72);
  const R a7 = b * fraction<R>(1, 54) + fraction<R>(1, 144);
  return LaurentPolynomial<R>(-6, {a7, a6, a5, a4, a3, a2, a1, a1, a2, a3, a4, a5, a6, a7});
}

/// Two such steps as ONE 9-ary step, z^-2 a(z) a(z^3) (equation (3.2)): mask on -26..26,
/// symmetric, interpolatory for every b.
template <class R>
[[nodiscard]] LaurentPolynomial<R> ternary_two_step_9(const R& b) {
  const auto step = ternary_two_step<R>(b);
  return (step * step.dilated(3)).shifted(-2);
}

/// The ternary interpolatory 4-point scheme of Hassan, Ivrissimtzis, Dodgson and Sabin (2002);
/// C^2 for 1/15 < mu < 1/9. Mask on -5..5.
template <class R>
[[nodiscard]] LaurentPolynomial<R> ternary_four_point(const R& mu) {
  const R a0 = fraction<R>(-1, 18) - mu * fraction<R>(1, 6);
  const R a1 = fraction<R>(13, 18) + mu * fraction<R>(1, 2);
  const R a2 = fraction<R>(7, 18) - mu * fraction<R>(1, 2);
  const R a3 = fraction<R>(-1, 18) + mu * fraction<R>(1, 6);
  return LaurentPolynomial<R>(-5, {a3, a0, R(0), a2, a1, R(1), a1, a2, R(0), a0, a3});
}

}  // namespace arete::family
