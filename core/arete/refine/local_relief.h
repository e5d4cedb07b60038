// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "arete/refine/input_window.h"

namespace arete {

/// The local relief of an input: at each of its samples the range (largest minus smallest) of the
/// valid samples among the 3 x 3 around it, 0 where there is none. Windows are cut by the ends of
/// the input, or go round where an axis is periodic.
template <class T>
class LocalRelief {
 public:
  /// Holds the rows number `rows` of the axis; beyond its ends only when y is periodic.
  /// \pre the window holds one row more on either side, where the input has one.
  LocalRelief(const InputWindow<T>& input, Boundaries boundaries, IndexRange rows);

  /// The relief at the samples of input row `row`, one after the other; beyond the ends it is
  /// that of the end, or goes round. The row has cols + 1 numbers: the last is what lies right of
  /// the last sample (itself, or the first one when x is periodic).
  [[nodiscard]] const T* row(Index row) const;

 private:
  bool turns_;   ///< y is periodic
  Index count_;  ///< rows of the input
  IndexRange rows_;
  Index width_;
  std::vector<T> relief_;
};

}  // namespace arete
