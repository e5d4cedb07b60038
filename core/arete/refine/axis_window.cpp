// SPDX-License-Identifier: MIT
#include "arete/refine/axis_window.h"

#include <algorithm>
#include <string>

namespace arete {
namespace {

// The real samples that the continued samples `needed` come from, as one run.
IndexRange real_samples(IndexRange needed, Boundary boundary, Index count) {
  const Index last = count - 1;
  // Folded more than once, a reflected axis reads samples of either end.
  if (needed.first < -last || needed.last > 2 * last) return {0, last};
  IndexRange real{std::clamp(needed.first, Index{0}, last),
                  std::clamp(needed.last, Index{0}, last)};
  for (const Index end : {needed.first, needed.last}) {
    const Continuation from = continued(boundary, end, count);
    real.first = std::min({real.first, from.near, from.far});
    real.last = std::max({real.last, from.near, from.far});
  }
  return real;
}

}  // namespace

AxisPlan AxisPlan::restricted(IndexRange outputs, IndexRange samples) const {
  AxisPlan part = *this;
  part.input_count_ = samples.count();
  if (boundary_ == Boundary::periodic && input_count_ > 1) part.boundary_ = Boundary::clamp;
  part.ranges_ = ranges_for(outputs);
  // Sample i of one level is sample m i of the next, so m times as many are left out before it.
  Index left_out = samples.first;
  for (std::size_t level = 0; level < part.ranges_.size(); ++level) {
    part.ranges_[level].first -= left_out;
    part.ranges_[level].last -= left_out;
    if (level < rules_.size()) left_out *= rules_[level].arity;
  }
  part.first_position_ = first_position_ + outputs.first * spacing_ - samples.first;
  return part;
}

AxisWindow window(const AxisPlan& plan, IndexRange outputs, Index reach) {
  if (outputs.count() < 1 || outputs.first < 0 || outputs.last >= plan.output_count())
    throw InvalidField("results " + std::to_string(outputs.first) + " to " +
                       std::to_string(outputs.last) + " are not among the " +
                       std::to_string(plan.output_count()) + " of this axis");
  const Index count = plan.input_count();
  if (count == 1) return {{0, 0}, plan.restricted(outputs, {0, 0})};

  const IndexRange needed = plan.ranges_for(outputs).front();
  const bool turn = plan.boundary() == Boundary::periodic;
  IndexRange samples = turn ? needed : real_samples(needed, plan.boundary(), count);
  // As much as InputWindow reads: `reach` + 1 rounds that look two samples far, which also covers
  // the cells beside a result.
  const Index margin = 2 * reach + 2;
  samples.first -= margin;
  samples.last += margin;
  if (!turn) {
    samples.first = std::max(samples.first, Index{0});
    samples.last = std::min(samples.last, count - 1);
  }
  return {samples, plan.restricted(outputs, samples)};
}

GridWindow grid_window(AxisPlan x, AxisPlan y, IndexRange rows, IndexRange cols) {
  x.pad_levels(y.rules().size());
  y.pad_levels(x.rules().size());
  const Index reach = std::max(x.reach(), y.reach());
  return {window(x, cols, reach), window(y, rows, reach)};
}

}  // namespace arete
