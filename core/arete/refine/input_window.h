// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "arete/field/boundary.h"
#include "arete/field/row_source.h"
#include "arete/refine/level_rule.h"

namespace arete {

/// A band of input rows held in memory, with its missing samples marked and replaced.
///
/// A missing sample (NaN or infinite) has no value, but stencils that end in a complete cell may
/// still read it. Within `reach` samples of complete cells it is replaced by linear extrapolation:
/// in rounds, each missing sample takes the mean of 2 p_1 - p_2 over those of the eight directions
/// in which p_1 and p_2, its first and second neighbour, are known. Hence
/// - a plane beside a hole is continued as that plane;
/// - what the missing samples held has no influence;
/// - the replacement depends on at most 2 `reach` samples around, so any cut into bands gives the
///   same bits.
/// Samples out of reach of every complete cell become 0; no valid result reads them.
template <class T>
class InputWindow {
 public:
  /// Reads what is needed for the level-0 rows `needed` (ghost rows included).
  InputWindow(const RowSource<T>& source, IndexRange needed, Boundaries boundaries, Index reach);

  [[nodiscard]] Extent source_extent() const { return extent_; }
  /// The level-0 row `index` at the level-0 columns `columns`; either may be ghosts.
  void continued_row(Index index, IndexRange columns, T* out) const;

  /// True when no sample of the window is missing.
  [[nodiscard]] bool complete() const { return complete_; }
  /// Whether the input had a sample at (row, col); both are folded into the axis when periodic and
  /// clamped to it otherwise. Rows must be within the window.
  [[nodiscard]] bool valid(Index row, Index col) const;

 private:
  [[nodiscard]] Index window_row(Index row) const;
  void mark_missing();
  void replace_missing(Index reach);
  bool replace_round(std::vector<std::uint8_t>& known);

  Extent extent_;
  Boundaries boundaries_;
  IndexRange rows_;  ///< rows held; beyond the axis' ends only when y is periodic
  std::vector<T> samples_;
  std::vector<std::uint8_t> valid_;
  bool complete_ = true;
};

}  // namespace arete
