// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "arete/fractal/matrix_set.h"
#include "arete/scheme/mask.h"
#include "arete/scheme/stencil.h"

namespace arete {

/// The matrices of any mask scheme, arc by arc.
///
/// With phi the basic limit function, supported on [first, last]/(m-1), the arc of the limit over
/// the parameters [0, 1] depends on the control points p_j with
/// -last/(m-1) < j < 1 - first/(m-1) only: `size()` points from number `first` on. Matrix d takes
/// them to those of the arc [d/m, (d+1)/m]:
///
///     (A_d)_{rs} = a_{d + (first + r) - m (first + s)}.
///
/// The control polygon of an arc at depth k is a window of the polygon refined k times, exactly.
/// Parameters are classical (without tau, see limit_stencil.h).
struct ArcMatrices {
  int first = 0;
  MatrixSet<Rational> set;
};

[[nodiscard]] ArcMatrices arc_matrices(const Mask& mask);

/// The exact weights of the limit at any rational parameter x: f(x) = sum_k w_k p_{first + k}.
///
/// The m-adic digits of x are eventually periodic; the weights are the fixed row of the product of
/// the period (see fixed_row), carried through the digits before it. At x = 0 this is
/// limit_stencil(). Meaningful only for schemes that converge: certify first.
///
/// Nothing is returned if that fixed row is not unique or if digits and period together are longer
/// than largest_expansion.
inline constexpr int largest_expansion = 200;
[[nodiscard]] std::optional<Stencil> limit_stencil_at(const Mask& mask, const Rational& x);

}  // namespace arete
