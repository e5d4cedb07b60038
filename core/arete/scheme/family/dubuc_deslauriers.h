// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "arete/algebra/fraction.h"

namespace arete::family {

/// The interpolatory scheme of Dubuc and Deslauriers (1986/89) on an even number of points: the
/// value midway between p_0 and p_1 of the polynomial of degree points-1 through the points/2
/// nearest samples on each side. 4 points: the 4-point scheme with omega = 1/16.
template <class R>
[[nodiscard]] LaurentPolynomial<R> dubuc_deslauriers(int points) {
  const int half_points = points / 2;
  LaurentPolynomial<R> symbol = LaurentPolynomial<R>::monomial(R(1), 0);
  // Lagrange's weight of node j in -half+1..half at 1/2; node j is read by the odd sample 1 through
  // the mask entry a_{1-2j}.
  for (int j = 1 - half_points; j <= half_points; ++j) {
    R weight(1);
    for (int i = 1 - half_points; i <= half_points; ++i)
      if (i != j) weight = weight * fraction<R>(1 - 2 * i, 2 * (j - i));
    symbol = symbol + LaurentPolynomial<R>::monomial(weight, 1 - 2 * j);
  }
  return symbol;
}

}  // namespace arete::family
