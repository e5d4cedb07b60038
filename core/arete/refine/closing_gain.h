// SPDX-License-Identifier: MIT
#pragma once

#include "arete/refine/axis_plan.h"

namespace arete {

/// Factors of the last two levels' displacements (see Detail).
struct ClosingGain {
  double last = 1;
  double before_last = 1;
};

/// All levels but the last ones are smoothed by the steps that follow, and lie under the
/// displacements of the levels that follow; so with plain amplitudes the last octaves of the
/// spectrum would not continue its power law. With these factors the mean power of either of the
/// last two octaves (frequencies 1/(2m)..1/2 a sample, m the arity, and m times lower; radially, in
/// two dimensions) is that of the octave two below times m^{-(2H+2)} an octave, given white
/// displacements of variance m^{-2Hl} at every level l, shaped by the schemes' own frequency
/// responses. 0 where the schemes alone put more there; 1 when no level displaces.
[[nodiscard]] ClosingGain closing_gain(const AxisPlan& x, const AxisPlan& y, double roughness);

}  // namespace arete
