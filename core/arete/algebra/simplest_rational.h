// SPDX-License-Identifier: MIT
#pragma once

#include "arete/algebra/rational.h"

namespace arete {

/// The fraction with the smallest denominator among those that round to `value`: 1/11 for the double
/// nearest to it. What a host that knows doubles only meant by a number.
/// Walks down the Stern-Brocot tree in steps of continued fractions. \pre value is finite.
[[nodiscard]] Rational simplest_rational(double value);

}  // namespace arete
