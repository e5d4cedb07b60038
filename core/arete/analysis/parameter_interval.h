// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>

#include "arete/algebra/rational.h"

namespace arete {

/// Where, around a start, something holds for a parameter: walks outwards in steps until it first
/// fails on either side (or `reach` is left), then bisects to `tolerance`. Each end is given as the
/// last value where it held and the first where it failed; gaps shorter than a step are not seen.
struct ParameterInterval {
  Rational lower;        ///< holds here
  Rational upper;        ///< holds here
  Rational fails_below;  ///< within tolerance below lower; = lower if it never failed in reach
  Rational fails_above;  ///< within tolerance above upper; = upper if it never failed in reach
};

struct IntervalSearch {
  Rational start;
  Rational step;
  Rational reach;  ///< how far from the start to walk
  Rational tolerance;
};

/// Nothing if it does not hold at the start. `holds` is called with rationals whose denominators
/// stay near that of start and step times step/tolerance.
[[nodiscard]] std::optional<ParameterInterval> interval_where(
    const std::function<bool(const Rational&)>& holds, const IntervalSearch& search);

}  // namespace arete
