// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "arete/refine/axis_window.h"

namespace arete::vtk_filters {

/// i, j, k: smallest and largest index of each, as in VTK.
using VtkExtent = std::array<int, 6>;

[[nodiscard]] inline bool is_empty(const VtkExtent& e) {
  return e[0] > e[1] || e[2] > e[3] || e[4] > e[5];
}
[[nodiscard]] inline Index count_along(const VtkExtent& e, int axis) {
  const auto a = static_cast<std::size_t>(axis);
  return Index{e[2 * a + 1]} - e[2 * a] + 1;
}
[[nodiscard]] inline IndexRange range_along(const VtkExtent& e, int axis) {
  const auto a = static_cast<std::size_t>(axis);
  return {e[2 * a], e[2 * a + 1]};
}

/// A structured data set before and after refinement along i and j; slices along k stay apart.
///
/// Input index i becomes result index i m^N, so that an axis that begins at i = -7 begins at -7 m^N
/// afterwards and only the shift of the scheme (tau) moves the origin.
struct StructuredPlan {
  AxisPlan x;
  AxisPlan y;
  VtkExtent input{};   ///< the whole one
  VtkExtent output{};  ///< the whole one

  /// \throws InvalidField if an index of the result does not fit an int, as VTK's extents need.
  StructuredPlan(AxisPlan x_plan, AxisPlan y_plan, const VtkExtent& whole_input);
};

/// A part of the result, and the part of the input that it is computed from.
class StructuredPiece {
 public:
  /// \pre `part` is not empty. \throws InvalidField if it is not within the plan's output.
  StructuredPiece(const StructuredPlan& plan, const VtkExtent& part);

  [[nodiscard]] const VtkExtent& part() const { return part_; }
  /// What must be asked from upstream, the halo included.
  [[nodiscard]] VtkExtent needed() const;
  [[nodiscard]] const StructuredPlan& plan() const { return plan_; }
  [[nodiscard]] const GridWindow& window() const { return window_; }
  /// Of the results, counted from the first of the whole.
  [[nodiscard]] IndexRange rows() const { return rows_; }
  [[nodiscard]] IndexRange cols() const { return cols_; }

  /// The index of window sample 0, 1, ... in the input; folded where an axis is periodic.
  [[nodiscard]] int input_i(Index window_col) const;
  [[nodiscard]] int input_j(Index window_row) const;

 private:
  StructuredPlan plan_;
  VtkExtent part_;
  IndexRange rows_;
  IndexRange cols_;
  GridWindow window_;
};

/// Whether all of `inner` is in `outer`.
[[nodiscard]] bool contains(const VtkExtent& outer, const VtkExtent& inner);

}  // namespace arete::vtk_filters
