// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <type_traits>

#include "arete/field/grid.h"
#include "arete/refine/combine.h"

namespace arete {

/// Samples along one axis, `lanes` lines of them side by side: sample i of every line is the run of
/// `lanes` numbers at data + i stride. A column of a grid, all columns at once, or one curve in any
/// dimension are all of this form. Borrowed.
///
/// Whatever is computed on lines is computed for each lane alone, so a cut into fewer lanes never
/// changes a bit.
template <class R>
struct Lines {
  R* data = nullptr;
  Index count = 0;
  Index lanes = 0;
  Index stride = 0;

  [[nodiscard]] R* operator[](Index i) const { return data + i * stride; }
  /// The samples first, first + 1, ... of the same lines.
  [[nodiscard]] Lines part(Index first, Index size) const {
    return {data + first * stride, size, lanes, stride};
  }
  operator Lines<const R>() const { return {data, count, lanes, stride}; }  // NOLINT
};

/// Lines of its own, without gaps; floating-point samples are not set until they are written.
template <class R>
class LineBuffer {
 public:
  LineBuffer(Index count, Index lanes)
      : count_(count),
        lanes_(lanes),
        samples_(std::make_unique_for_overwrite<R[]>(static_cast<std::size_t>(count * lanes))) {}
  [[nodiscard]] Lines<R> lines() { return {samples_.get(), count_, lanes_, lanes_}; }

 private:
  Index count_;
  Index lanes_;
  std::unique_ptr<R[]> samples_;
};

/// out[c] = weights[0] lines[0][c] + weights[1] lines[1][c] + ..., from left to right, over any
/// ring. In float and double this is the engine's own hot loop.
template <class R>
void weighted_sum(R* out, const R* const* lines, const R* weights, int taps, Index lanes) {
  if constexpr (std::is_floating_point_v<R>)
    combine(out, lines, weights, taps, lanes);
  else
    combine_reference(out, lines, weights, taps, lanes);
}

/// out[c] += weight * line[c].
template <class R>
void add_line(R* out, const R* line, const R& weight, Index lanes) {
  for (Index c = 0; c < lanes; ++c) out[c] = out[c] + weight * line[c];
}

}  // namespace arete
