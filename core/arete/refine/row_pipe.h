// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "arete/refine/axis_plan.h"
#include "arete/refine/displacement.h"
#include "arete/refine/input_window.h"

namespace arete {

/// The engine: k levels as k pipes of rows in series. Each level takes the rows of the level before
/// in order and gives its own in order, holding only as many as its stencils are tall, so no
/// intermediate level ever exists and every row is still in cache when it is used. A level filters
/// vertically first (on the narrower rows), then horizontally.
///
/// Working memory: O(sum over levels of width x stencil height). The value of a result is one fixed
/// expression of the input, whatever the band it is computed in.
template <class T>
class RowPipe {
 public:
  /// What is added between the levels; both null for none.
  struct Hook {
    const Displacement<T>* displacement = nullptr;
    const LocalRelief<T>* relief = nullptr;
  };

  /// A pipe for the results number `outputs` (rows, 0-based) of the plans, all columns. All that is
  /// given must outlive it. Both axes have equally many levels (AxisPlan::pad_levels).
  RowPipe(const std::vector<PhasedRule<T>>& y_rules, const AxisPlan& y,
          const std::vector<PhasedRule<T>>& x_rules, const AxisPlan& x, const InputWindow<T>& input,
          IndexRange outputs, Hook detail = {});

  /// Writes the next result row (x.output_count() samples).
  void next(T* out);

 private:
  /// The rows of one level that later rows may still need.
  struct Ring {
    IndexRange columns;
    Index height = 0;
    Index next_row = 0;  ///< not yet computed
    std::vector<T> samples;

    [[nodiscard]] T* row(Index r) {
      return samples.data() + ((r % height + height) % height) * columns.count();
    }
  };

  void advance(std::size_t level, Index row);
  void read_input_row(Index row, T* out);
  void compute_row(std::size_t level, Index row, T* out);
  void filter_row(std::size_t level, Index row, T* out);

  const std::vector<PhasedRule<T>>& y_rules_;
  const std::vector<PhasedRule<T>>& x_rules_;
  const InputWindow<T>& input_;
  Hook detail_;
  Boundary x_boundary_;
  std::size_t depth_;
  std::vector<Ring> rings_;  ///< levels 0..depth-1
  IndexRange result_columns_;
  Index next_result_;
  std::vector<T> column_sums_;  ///< one row of a level after its vertical filter
  std::vector<T> phase_line_;   ///< one phase of a row after its horizontal filter
  std::vector<T> other_line_;
  std::vector<const T*> lines_;
  std::vector<T> relief_line_;
};

}  // namespace arete
