// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "arete/refine/axis_plan.h"

namespace arete::openmesh::detail {

/// Where a sample lies among the old ones: between old samples `cell` and `cell` + 1 (the first
/// again after the last where the axis wraps), the part t of the way.
struct Location {
  Index cell = 0;
  double t = 0;
  /// The old sample it coincides with, -1 if none.
  Index sample = -1;

  [[nodiscard]] Index nearest(Index count) const { return (t < 0.5 ? cell : cell + 1) % count; }
};

/// One axis of a patch before and after refinement. Places are computed exactly.
struct RefinedAxis {
  AxisPlan plan;
  bool wraps = false;
  std::vector<Location> samples;  ///< of every new sample
  std::vector<Location> middles;  ///< of the middle of every new cell; sample is not used
  /// Old sample i is new sample i `stride`; 0 if old samples are not among the new ones.
  Index stride = 0;

  [[nodiscard]] Index coarse() const { return plan.input_count(); }
  [[nodiscard]] Index coarse_cells() const { return coarse() - (wraps ? 0 : 1); }
  [[nodiscard]] Index fine() const { return plan.output_count(); }
  [[nodiscard]] Index fine_cells() const { return fine() - (wraps ? 0 : 1); }
};

/// \throws InvalidField if fewer than two samples (three where it wraps) are left.
[[nodiscard]] RefinedAxis refined_axis(AxisPlan plan, bool wraps);

}  // namespace arete::openmesh::detail
