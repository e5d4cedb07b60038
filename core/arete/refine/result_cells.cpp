// SPDX-License-Identifier: MIT
#include "arete/refine/result_cells.h"

#include <algorithm>

namespace arete {

ResultCells::ResultCells(const AxisPlan& plan)
    : count_(plan.input_count()),
      turns_(plan.boundary() == Boundary::periodic),
      first_(plan.first_position()),
      spacing_(plan.spacing()) {
  namespace mp = boost::multiprecision;
  const Integer unit = mp::lcm(mp::denominator(first_), mp::denominator(spacing_));
  const Integer start = mp::numerator(Rational(first_ * unit));
  const Integer step = mp::numerator(Rational(spacing_ * unit));
  const Integer largest = mp::abs(start) + mp::abs(step) * plan.output_count() + unit;
  if (largest < (Integer(1) << 62))
    small_ = {static_cast<Index>(start), static_cast<Index>(step), static_cast<Index>(unit)};
}

IndexRange ResultCells::at(Index i) const {
  if (count_ == 1) return {0, 0};
  Index whole = 0;
  bool on_sample = false;
  if (small_) {
    const Index position = small_->start + i * small_->step;
    whole = floor_divide(position, small_->unit);
    on_sample = position == whole * small_->unit;
  } else {
    const Rational position = first_ + i * spacing_;
    whole = static_cast<Index>(floor(position));
    on_sample = is_integer(position);
  }
  const IndexRange cells{on_sample ? whole - 1 : whole, whole};
  if (turns_) return cells;
  const auto clamp = [&](Index cell) { return std::clamp(cell, Index{0}, count_ - 2); };
  return {clamp(cells.first), clamp(cells.last)};
}

}  // namespace arete
