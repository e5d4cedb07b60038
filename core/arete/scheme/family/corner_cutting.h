// SPDX-License-Identifier: MIT
#pragma once

#include "arete/algebra/fraction.h"

namespace arete::family {

/// General corner cutting (Kotarski and Gdawiec): f_{2j} = (1-u) c_j + u c_{j+1},
/// f_{2j+1} = v c_j + (1-v) c_{j+1}; mask on -2..1. Converges for u, v >= 0, 0 < u+v < 1;
/// C^1 in the dyadic parameter iff u + v = 1/2 with u, v > 0.
template <class R>
[[nodiscard]] LaurentPolynomial<R> corner_cutting(const R& u, const R& v) {
  return LaurentPolynomial<R>(-2, {u, R(1) - v, R(1) - u, v});
}

/// Chaikin (1974): u = v = 1/4, the quadratic B-spline. C^1.
template <class R>
[[nodiscard]] LaurentPolynomial<R> chaikin() {
  return corner_cutting<R>(fraction<R>(1, 4), fraction<R>(1, 4));
}

/// de Rham (1947): u = v = 1/3. C^0 in the dyadic parameter (as a curve it has a tangent).
template <class R>
[[nodiscard]] LaurentPolynomial<R> de_rham() {
  return corner_cutting<R>(fraction<R>(1, 3), fraction<R>(1, 3));
}

}  // namespace arete::family
