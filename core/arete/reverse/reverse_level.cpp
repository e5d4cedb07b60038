// SPDX-License-Identifier: MIT
#include "arete/reverse/reverse_level.h"

#include <string>

namespace arete {

ReverseLevel::ReverseLevel(const Mask& mask, Index count, Boundary boundary)
    : fine_count(count),
      closed(boundary == Boundary::periodic),
      arity(mask.arity()),
      tau(mask.tau()) {
  if (count < 1)
    throw InvalidField("an axis of " + std::to_string(count) +
                       " samples cannot be reversed; give at least one sample");
  if (boundary == Boundary::none)
    throw InvalidField(
        "boundary none has no reverse (the samples beyond the ends would be "
        "unknown); choose extrapolate, clamp, reflect or periodic");
  const Index m = arity;
  if (closed) {
    coarse_count = ceil_divide(count, m);
    padding = count == 1 ? 0 : m * coarse_count - count;
    rows = {0, count + padding - 1};
    return;
  }
  const Index on_lattice = is_integer(tau) ? 1 : 0;
  coarse_count = floor_divide(count - on_lattice, m) + 1;
  const Index nodes = m * (coarse_count - 1) + on_lattice;
  const Index first = static_cast<Index>(ceil(tau)) - (count - nodes) / 2;
  rows = {first, first + count - 1};
}

AxisPlacement ReverseLevel::placement() const {
  if (fine_count == 1) return {1, 0, 1};
  return {coarse_count, to_double(Rational(tau - rows.first)), static_cast<double>(arity)};
}

AxisPlacement composed(const AxisPlacement& outer, const AxisPlacement& inner) {
  return {inner.count, outer.first + inner.first * outer.spacing, inner.spacing * outer.spacing};
}

}  // namespace arete
