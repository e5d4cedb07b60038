// SPDX-License-Identifier: MIT
#include "arete/algebra/simplest_rational.h"

#include <cmath>
#include <limits>

namespace arete {
namespace {

// The simplest fraction in the closed interval [low, high], 0 <= low < high.
Rational simplest_between(const Rational& low, const Rational& high) {
  const Integer whole = floor(low);
  if (Rational(whole) == low) return low;
  if (Rational(whole + 1) <= high) return whole + 1;
  return whole + 1 / simplest_between(1 / (high - whole), 1 / (low - whole));
}

}  // namespace

Rational simplest_rational(double value) {
  if (value == 0) return 0;
  if (value < 0) return -simplest_rational(-value);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Rational exact(value);
  const Rational below = (exact - Rational(std::nextafter(value, 0))) / 2;
  const double next = std::nextafter(value, infinity);
  const Rational above = std::isfinite(next) ? Rational((Rational(next) - exact) / 2) : below;
  const Rational simplest = simplest_between(exact - below, exact + above);
  // Half way to a neighbour need not round back.
  return to_double(simplest) == value ? simplest : exact;
}

}  // namespace arete
