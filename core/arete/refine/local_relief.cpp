// SPDX-License-Identifier: MIT
#include "arete/refine/local_relief.h"

#include <algorithm>
#include <limits>

namespace arete {
namespace {

// Largest and smallest of some samples.
template <class T>
struct Span {
  T low = std::numeric_limits<T>::infinity();
  T high = -std::numeric_limits<T>::infinity();

  void include(const Span& other) {
    low = std::min(low, other.low);
    high = std::max(high, other.high);
  }
};

// The valid samples of three rows, column by column.
template <class T>
std::vector<Span<T>> column_spans(const InputWindow<T>& input, Boundary y, Index row) {
  const Extent extent = input.source_extent();
  std::vector<Span<T>> spans(static_cast<std::size_t>(extent.cols));
  std::vector<T> line(static_cast<std::size_t>(extent.cols));
  for (Index r = row - 1; r <= row + 1; ++r) {
    if (y != Boundary::periodic && (r < 0 || r >= extent.rows)) continue;
    input.continued_row(r, {0, extent.cols - 1}, line.data());
    for (Index c = 0; c < extent.cols; ++c) {
      const T value = line[static_cast<std::size_t>(c)];
      if (input.valid(r, c)) spans[static_cast<std::size_t>(c)].include({value, value});
    }
  }
  return spans;
}

}  // namespace

template <class T>
LocalRelief<T>::LocalRelief(const InputWindow<T>& input, Boundaries boundaries, IndexRange rows)
    : turns_(boundaries.y == Boundary::periodic),
      count_(input.source_extent().rows),
      rows_(rows),
      width_(input.source_extent().cols + 1) {
  const Index cols = input.source_extent().cols;
  const bool turn = boundaries.x == Boundary::periodic;
  relief_.resize(static_cast<std::size_t>(rows.count() * width_));
  for (Index r = rows.first; r <= rows.last; ++r) {
    const std::vector<Span<T>> spans = column_spans(input, boundaries.y, r);
    T* line = relief_.data() + (r - rows.first) * width_;
    for (Index c = 0; c < cols; ++c) {
      Span<T> around = spans[static_cast<std::size_t>(c)];
      for (Index beside : {c - 1, c + 1}) {
        if (turn) beside = (beside + cols) % cols;
        if (beside >= 0 && beside < cols) around.include(spans[static_cast<std::size_t>(beside)]);
      }
      line[c] = around.high >= around.low ? around.high - around.low : T(0);
    }
    line[cols] = turn ? line[0] : line[cols - 1];
  }
}

template <class T>
const T* LocalRelief<T>::row(Index row) const {
  if (turns_) row = continued(Boundary::periodic, row - rows_.first, count_).near + rows_.first;
  return relief_.data() + (std::clamp(row, rows_.first, rows_.last) - rows_.first) * width_;
}

template class LocalRelief<float>;
template class LocalRelief<double>;

}  // namespace arete
