// SPDX-License-Identifier: MIT
#pragma once

#include "arete/algebra/laurent_polynomial.h"

namespace arete {

/// p/q as an element of the coefficient ring R. The formulas of the scheme families are written
/// over any R in which small fractions exist: exact rationals, doubles, and polynomials in a
/// symbolic parameter over either of them.
template <class R>
struct Fraction {
  [[nodiscard]] static R of(int p, int q) { return R(p) / R(q); }
};

template <class R>
struct Fraction<LaurentPolynomial<R>> {
  [[nodiscard]] static LaurentPolynomial<R> of(int p, int q) {
    return LaurentPolynomial<R>(0, {Fraction<R>::of(p, q)});
  }
};

/// Shorthand: fraction<R>(9, 16).
template <class R>
[[nodiscard]] R fraction(int p, int q) {
  return Fraction<R>::of(p, q);
}

}  // namespace arete
