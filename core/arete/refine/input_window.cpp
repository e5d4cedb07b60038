// SPDX-License-Identifier: MIT
#include "arete/refine/input_window.h"

#include <algorithm>
#include <cmath>

#include "arete/refine/kernel/kernel.h"

namespace arete {
namespace {

// The real rows that continued rows `needed` come from, as one run (not folded when periodic).
IndexRange real_rows(IndexRange needed, Boundary boundary, Index count) {
  if (boundary == Boundary::periodic) return needed;
  IndexRange real{count, -1};
  const auto include = [&](Index row) {
    real.first = std::min(real.first, row);
    real.last = std::max(real.last, row);
  };
  for (Index row = needed.first; row <= needed.last; ++row) {
    const Continuation from = continued(boundary, row, count);
    include(from.near);
    include(from.far);
  }
  return real;
}

}  // namespace

template <class T>
InputWindow<T>::InputWindow(const RowSource<T>& source, IndexRange needed, Boundaries boundaries,
                            Index reach)
    : extent_(source.extent()), boundaries_(boundaries) {
  rows_ = real_rows(needed, boundaries.y, extent_.rows);
  const Index margin = 2 * reach + 2;
  rows_.first -= margin;
  rows_.last += margin;
  if (boundaries.y != Boundary::periodic) {
    rows_.first = std::max(rows_.first, Index{0});
    rows_.last = std::min(rows_.last, extent_.rows - 1);
  }
  samples_.resize(static_cast<std::size_t>(rows_.count() * extent_.cols));
  for (Index row = rows_.first; row <= rows_.last; ++row)
    source.read(continued(Boundary::periodic, row, extent_.rows).near,
                samples_.data() + (row - rows_.first) * extent_.cols);
  mark_missing();
  if (!complete_) replace_missing(reach + 1);
}

template <class T>
Index InputWindow<T>::window_row(Index row) const {
  if (boundaries_.y == Boundary::periodic) {
    while (row < rows_.first) row += extent_.rows;
    while (row > rows_.last) row -= extent_.rows;
    return row - rows_.first;
  }
  return std::clamp(row, Index{0}, extent_.rows - 1) - rows_.first;
}

template <class T>
void InputWindow<T>::continued_row(Index index, IndexRange columns, T* out) const {
  Continuation from{index, index, 0};
  if (boundaries_.y != Boundary::periodic) from = continued(boundaries_.y, index, extent_.rows);
  const T* near = samples_.data() + window_row(from.near) * extent_.cols;
  const T* far = samples_.data() + window_row(from.far) * extent_.cols;
  const T steps = static_cast<T>(from.steps);
  const auto sample = [&](Index c) {
    return from.steps == 0 ? near[c] : near[c] + steps * (near[c] - far[c]);
  };
  const auto ghosts = [&](Index first, Index last) {
    for (Index c = first; c <= last; ++c) {
      const Continuation beside = continued(boundaries_.x, c, extent_.cols);
      const T end = sample(beside.near);
      out[c - columns.first] =
          beside.steps == 0 ? end : end + static_cast<T>(beside.steps) * (end - sample(beside.far));
    }
  };
  const Index first = std::max(columns.first, Index{0});
  const Index last = std::min(columns.last, extent_.cols - 1);
  ghosts(columns.first, std::min(columns.last, Index{-1}));
  if (from.steps == 0 && first <= last)
    std::copy(near + first, near + last + 1, out + (first - columns.first));
  else
    for (Index c = first; c <= last; ++c) out[c - columns.first] = sample(c);
  ghosts(std::max(columns.first, extent_.cols), columns.last);
}

template <class T>
bool InputWindow<T>::valid(Index row, Index col) const {
  if (complete_) return true;
  col = boundaries_.x == Boundary::periodic ? continued(Boundary::periodic, col, extent_.cols).near
                                            : std::clamp(col, Index{0}, extent_.cols - 1);
  return valid_[static_cast<std::size_t>(window_row(row) * extent_.cols + col)] != 0;
}

template <class T>
void InputWindow<T>::mark_missing() {
  complete_ = kernels<T>().all_finite(samples_.data(), static_cast<Index>(samples_.size()));
  if (complete_) return;
  valid_.resize(samples_.size());
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    valid_[i] = std::isfinite(samples_[i]) ? 1 : 0;
    if (valid_[i] == 0) samples_[i] = T(0);
  }
}

template <class T>
void InputWindow<T>::replace_missing(Index reach) {
  std::vector<std::uint8_t> known = valid_;
  for (Index round = 0; round < reach; ++round)
    if (!replace_round(known)) return;
}

// One round; a sample replaced in it is known from the next round on. Returns whether any was.
template <class T>
bool InputWindow<T>::replace_round(std::vector<std::uint8_t>& known) {
  const Index rows = rows_.count();
  const Index cols = extent_.cols;
  const bool turn = boundaries_.x == Boundary::periodic;
  const std::vector<std::uint8_t> before = known;
  bool replaced = false;
  for (Index r = 0; r < rows; ++r) {
    for (Index c = 0; c < cols; ++c) {
      if (before[static_cast<std::size_t>(r * cols + c)] != 0) continue;
      T sum = 0;
      int directions = 0;
      for (Index dr = -1; dr <= 1; ++dr) {
        for (Index dc = -1; dc <= 1; ++dc) {
          const Index r2 = r + 2 * dr;
          Index c1 = c + dc;
          Index c2 = c + 2 * dc;
          if ((dr == 0 && dc == 0) || r2 < 0 || r2 >= rows) continue;
          if (turn) {
            c1 = continued(Boundary::periodic, c1, cols).near;
            c2 = continued(Boundary::periodic, c2, cols).near;
          } else if (c2 < 0 || c2 >= cols) {
            continue;
          }
          const auto first = static_cast<std::size_t>((r + dr) * cols + c1);
          const auto second = static_cast<std::size_t>(r2 * cols + c2);
          if (before[first] == 0 || before[second] == 0) continue;
          sum = sum + (samples_[first] + (samples_[first] - samples_[second]));
          ++directions;
        }
      }
      if (directions == 0) continue;
      samples_[static_cast<std::size_t>(r * cols + c)] = sum / static_cast<T>(directions);
      known[static_cast<std::size_t>(r * cols + c)] = 1;
      replaced = true;
    }
  }
  return replaced;
}

template class InputWindow<float>;
template class InputWindow<double>;

}  // namespace arete
