// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "arete/fractal/matrix_set.h"

namespace arete {

/// The sub-arcs taken, coarsest first; 0 <= digit < arity. The empty address is the whole arc.
using Address = std::vector<int>;

/// A_{w_k} ... A_{w_1}: the control points of the arc at the address, from those of the whole.
template <class R>
[[nodiscard]] Matrix<R> address_product(const MatrixSet<R>& set, const Address& address) {
  auto product = Matrix<R>::identity(set.size());
  for (const int digit : address) product = set[digit] * product;
  return product;
}

/// The row b with b a = b and sum 1, if there is exactly one: the weights, on the control points of
/// an arc, of the point that the map `a` leaves in place. For the product of an address it is the
/// curve's point at the parameter 0.(address repeated for ever). For L of a pair: the start of the
/// arc. Nothing if 1 is a multiple eigenvalue, or none.
[[nodiscard]] std::optional<std::vector<Rational>> fixed_row(const Matrix<Rational>& a);

/// The weights of the curve's point at the rational parameter 0 <= x <= 1 of an arc, exact.
/// Nothing if fixed_row gives nothing or the m-adic expansion has more than max_digits digits
/// before it repeats. \throws std::invalid_argument for x outside 0..1.
[[nodiscard]] std::optional<std::vector<Rational>> limit_row(const MatrixSet<Rational>& set,
                                                             const Rational& x, int max_digits);

}  // namespace arete
