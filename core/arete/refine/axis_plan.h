// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "arete/field/boundary.h"
#include "arete/field/georeference.h"
#include "arete/refine/level_rule.h"
#include "arete/scheme/mask.h"
#include "arete/scheme/stencil.h"

namespace arete {

/// Where the refined samples shall lie.
enum class Alignment {
  nodes,  ///< within the range of the input's samples; for tau = 0 exactly m^N (n-1) + 1 of them
  cells   ///< n m^N samples, the centres of the pixels of the same bounding box cut finer
};

/// What a filter after the last level makes.
enum class FinalResult {
  samples,   ///< new samples, which lie where the limit is evaluated (see AxisPlan)
  attribute  ///< one more number of each sample (a derivative): counted and placed as without
             ///< filter
};

/// What is done along one axis.
struct AxisOptions {
  int levels = 1;
  Boundary boundary = Boundary::extrapolate;
  Alignment alignment = Alignment::nodes;
  /// A filter applied to the last level, e.g. limit or derivative stencils.
  std::optional<Stencil> final_stencil;
  FinalResult final_result = FinalResult::samples;
};

/// Everything about refining `count` samples along one axis that does not depend on their values:
/// the rule of every level, the indices each level must hold, and where the results lie.
///
/// Positions. With tau = a'(1)/m, sample i of level N lies at (i + s)/m^N among the input's
/// samples, s = -tau (m^N - 1)/(m - 1): so linear data stay where they are for every scheme with
/// two sum rules, asymmetric and dual ones included. Samples made by a limit stencil lie at the
/// classical parameter of theirs: s = -tau m^N/(m - 1).
///
/// - `nodes` keeps those i with 0 <= (i + s)/m^N <= count - 1; `periodic` keeps i = 0..count m^N -
/// 1
///   (one turn); `none` keeps what can be computed without ghosts.
/// - `cells` wants the positions (j + 1/2)/m^N - 1/2, j = 0..count m^N - 1. They are on the lattice
///   of level N (dual binary, primal ternary schemes), or on that of level N+1 (primal binary
///   schemes), of which then only the wanted phase is computed. For any other tau the nearest
///   samples of the lattice are kept and misplacement() tells how far off they lie.
/// - A single sample is a constant axis: one sample for `nodes`.
class AxisPlan {
 public:
  /// \throws InvalidField if count < 1, levels < 0, the result would exceed 2^40 samples, or
  /// nothing can be computed (boundary none on too few samples; the message says how many).
  AxisPlan(const Mask& mask, Index count, const AxisOptions& options);

  /// The axis as it is: no level, `count` samples.
  [[nodiscard]] static AxisPlan identity(Index count);

  [[nodiscard]] Index input_count() const { return input_count_; }
  [[nodiscard]] Index output_count() const { return ranges_.back().count(); }
  [[nodiscard]] Boundary boundary() const { return boundary_; }

  [[nodiscard]] const std::vector<LevelRule>& rules() const { return rules_; }
  /// Indices held at every level for the whole result; ranges()[0] may reach outside 0..count-1
  /// (ghosts), the last one is the result.
  [[nodiscard]] const std::vector<IndexRange>& ranges() const { return ranges_; }
  /// The same for the results number first..last (0-based).
  [[nodiscard]] std::vector<IndexRange> ranges_for(IndexRange outputs) const;

  /// Position of result i, in samples of the input: first_position() + i spacing(). Exact.
  [[nodiscard]] const Rational& first_position() const { return first_position_; }
  [[nodiscard]] const Rational& spacing() const { return spacing_; }
  [[nodiscard]] AxisPlacement placement() const;
  /// How far the results lie beyond the asked positions, in samples of the input; 0 when exact.
  [[nodiscard]] const Rational& misplacement() const { return misplacement_; }

  /// Puts rules that change nothing before the first until there are `count` (an engine that runs
  /// two axes in step needs equally many).
  void pad_levels(std::size_t count);

  /// The results `outputs` as an axis of its own that reads the real samples `samples` only,
  /// numbered from 0. window() (axis_window.h) says which samples those must be.
  [[nodiscard]] AxisPlan restricted(IndexRange outputs, IndexRange samples) const;

  /// How many samples beyond its own cell [floor(x), floor(x)+1] a result may read at level 0.
  [[nodiscard]] Index reach() const;

 private:
  AxisPlan() = default;
  void plan_lattice(const Mask& mask, const AxisOptions& options);
  void plan_further_level(const Mask& mask, const AxisOptions& options, const Integer& offset);
  [[nodiscard]] std::vector<IndexRange> ranges_back_from(IndexRange last) const;

  Index input_count_ = 1;
  Boundary boundary_ = Boundary::extrapolate;
  std::vector<LevelRule> rules_;
  std::vector<IndexRange> ranges_;
  Rational first_position_ = 0;
  Rational spacing_ = 1;
  Rational misplacement_ = 0;
};

}  // namespace arete
