// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "arete/refine/axis_plan.h"

namespace arete {

/// Where something new lies among the old samples of an axis: between samples `cell` and `cell` + 1
/// (on a periodic axis the first again after the last), the part t of the way. t leaves 0..1 only
/// beyond the ends of an open axis. On an axis of one sample cell and t are 0.
struct AxisPlace {
  Index cell = 0;
  double t = 0;
};

/// Of the results `outputs` of the plan. Computed exactly, then rounded once.
[[nodiscard]] std::vector<AxisPlace> sample_places(const AxisPlan& plan, IndexRange outputs);

/// Of the middles between result i and i + 1, for i in `outputs`: the old cell is the parent of the
/// new one.
[[nodiscard]] std::vector<AxisPlace> middle_places(const AxisPlan& plan, IndexRange outputs);

}  // namespace arete
