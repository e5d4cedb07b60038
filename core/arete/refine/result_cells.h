// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "arete/refine/axis_plan.h"

namespace arete {

/// The input cells that the results along an axis lie in; cell i is the interval between the input
/// samples i and i + 1.
class ResultCells {
 public:
  explicit ResultCells(const AxisPlan& plan);

  /// The cells that hold result number i: two where it stands on a sample, given as first and last.
  /// Beyond the ends the nearest cell, unless the axis is periodic. An axis of one sample has cell
  /// 0.
  [[nodiscard]] IndexRange at(Index i) const;

 private:
  /// Position of result i: (start + i step) / unit.
  struct Fractions {
    Index start, step, unit;
  };

  Index count_;
  bool turns_;
  Rational first_;
  Rational spacing_;
  std::optional<Fractions> small_;  ///< when everything fits in 64 bits
};

}  // namespace arete
