// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "arete/refine/axis_plan.h"

namespace arete::meshlab {

/// One sample of a refined axis: what the engine computed as number `result` lies the part `t` of
/// the way from old sample `cell` to the next one (after the last comes the first on an axis that
/// wraps; t may leave 0..1 only at the rim, where places are extrapolated).
struct AxisSample {
  Index result = 0;
  Index cell = 0;
  double t = 0;
};

/// The interval between two neighbouring new samples: the old cell that holds its middle, and where
/// its ends are in that cell (0 and 1 are the old samples; an interval may stick out).
struct AxisCell {
  Index owner = 0;
  double begin = 0;
  double end = 1;
};

/// A refined axis of a mesh: the new samples, the new intervals, and which new sample takes the
/// place of each old one.
///
/// A mesh stays within its rim: on an open axis only samples at 0..count-1 are kept, for boundary
/// periodic too (where the heights beyond the rim are those of the other side).
class AxisSamples {
 public:
  /// \pre wraps only with boundary periodic.
  /// \throws InvalidField if fewer than two samples (three if it wraps) are left.
  AxisSamples(const AxisPlan& plan, bool wraps);

  [[nodiscard]] const std::vector<AxisSample>& samples() const { return samples_; }
  [[nodiscard]] const std::vector<AxisCell>& cells() const { return cells_; }
  /// The new sample that becomes old sample i: the nearest one, the earlier of two; -1 if none is
  /// nearer than the new spacing. Different old samples get different new ones.
  [[nodiscard]] const std::vector<Index>& successors() const { return successors_; }

 private:
  void locate_samples(const AxisPlan& plan);
  void locate_cells();
  void find_successors();

  Index count_;
  bool wraps_;
  Rational spacing_;
  std::vector<Rational> places_;
  std::vector<AxisSample> samples_;
  std::vector<AxisCell> cells_;
  std::vector<Index> successors_;
};

}  // namespace arete::meshlab
