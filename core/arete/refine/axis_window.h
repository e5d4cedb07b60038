// SPDX-License-Identifier: MIT
#pragma once

#include "arete/refine/axis_plan.h"

namespace arete {

/// A run of results of an axis, and the samples it is computed from: what hosts need that ask for
/// pieces of a result (VTK extents, tiles, ranks) and may hold only a piece of the input.
struct AxisWindow {
  /// What must be held. On a periodic axis it may reach beyond 0..count-1; sample i then is sample
  /// i mod count.
  IndexRange samples;
  /// Takes these samples, numbered from 0, to the results asked for. On a periodic axis the plan is
  /// an open one that needs no ghosts.
  AxisPlan plan;

  /// The real samples to ask a host for that knows no axis without ends: the whole axis when the
  /// window crosses the seam.
  [[nodiscard]] IndexRange real_samples(Index count) const {
    const bool inside = samples.first >= 0 && samples.last < count;
    return inside ? samples : IndexRange{0, count - 1};
  }
};

/// The window of the results number outputs.first..outputs.last (0-based) of `plan`.
///
/// Refiner(x.plan, y.plan) on the samples of two windows gives the very bits of the whole, missing
/// samples included, if `reach` is the larger AxisPlan::reach() of both axes: the window holds the
/// halo of all stencils and what the continuation beyond missing samples looks at. Random detail
/// (detail.h) is not covered: it is tied to the numbers of a whole.
/// \throws InvalidField if the outputs are none, or not all results of the plan.
[[nodiscard]] AxisWindow window(const AxisPlan& plan, IndexRange outputs, Index reach);

/// The windows of a rectangle of results of a grid.
struct GridWindow {
  AxisWindow x;
  AxisWindow y;

  /// Of the samples to hold.
  [[nodiscard]] Extent extent() const { return {y.samples.count(), x.samples.count()}; }
};

/// \throws InvalidField as window().
[[nodiscard]] GridWindow grid_window(AxisPlan x, AxisPlan y, IndexRange rows, IndexRange cols);

}  // namespace arete
