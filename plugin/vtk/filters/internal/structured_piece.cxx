// SPDX-License-Identifier: MIT
#include "internal/structured_piece.h"

#include <limits>
#include <string>

namespace arete::vtk_filters {
namespace {

// The indices of the results of an axis that begins at `first`.
IndexRange result_range(const AxisPlan& plan, int first) {
  // The spacing is 1/m^N. The product need not fit an Index, so its size is looked at first.
  const Rational fine = 1 / plan.spacing();
  const double begin = to_double(fine) * first;
  const double end = begin + static_cast<double>(plan.output_count() - 1);
  constexpr double largest = std::numeric_limits<int>::max();
  if (end > largest || begin < -largest)
    throw InvalidField("the result would reach index " + std::to_string(end) +
                       " along one axis, more than VTK can count; use fewer levels");
  return {static_cast<Index>(begin), static_cast<Index>(end)};
}

IndexRange moved(IndexRange range, Index by) { return {range.first + by, range.last + by}; }

int folded(Index sample, Index count) {
  return static_cast<int>(continued(Boundary::periodic, sample, count).near);
}

}  // namespace

StructuredPlan::StructuredPlan(AxisPlan x_plan, AxisPlan y_plan, const VtkExtent& whole_input)
    : x(std::move(x_plan)), y(std::move(y_plan)), input(whole_input), output(whole_input) {
  const IndexRange i = result_range(x, input[0]);
  const IndexRange j = result_range(y, input[2]);
  output = {static_cast<int>(i.first),
            static_cast<int>(i.last),
            static_cast<int>(j.first),
            static_cast<int>(j.last),
            input[4],
            input[5]};
}

StructuredPiece::StructuredPiece(const StructuredPlan& plan, const VtkExtent& part)
    : plan_(plan),
      part_(part),
      rows_(moved(range_along(part, 1), -plan.output[2])),
      cols_(moved(range_along(part, 0), -plan.output[0])),
      window_(grid_window(plan.x, plan.y, rows_, cols_)) {}

VtkExtent StructuredPiece::needed() const {
  const IndexRange i = moved(window_.x.real_samples(plan_.x.input_count()), plan_.input[0]);
  const IndexRange j = moved(window_.y.real_samples(plan_.y.input_count()), plan_.input[2]);
  return {static_cast<int>(i.first),
          static_cast<int>(i.last),
          static_cast<int>(j.first),
          static_cast<int>(j.last),
          part_[4],
          part_[5]};
}

int StructuredPiece::input_i(Index window_col) const {
  return plan_.input[0] + folded(window_.x.samples.first + window_col, plan_.x.input_count());
}

int StructuredPiece::input_j(Index window_row) const {
  return plan_.input[2] + folded(window_.y.samples.first + window_row, plan_.y.input_count());
}

bool contains(const VtkExtent& outer, const VtkExtent& inner) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (inner[2 * axis] < outer[2 * axis] || inner[2 * axis + 1] > outer[2 * axis + 1])
      return false;
  return true;
}

}  // namespace arete::vtk_filters
