// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "arete/field/grid.h"

namespace arete {

/// A square system of n equations whose entries lie within `lower` places below and `upper` above
/// the diagonal, over any field R; fill it with at(), then factor() once and solve() any number of
/// right-hand sides.
///
/// Gaussian elimination with row exchanges (in floating point the largest pivot, otherwise any that
/// is not zero). Cost n lower (lower + upper) to factor, n (2 lower + upper) to solve; memory
/// n (2 lower + upper + 1).
template <class R>
class BandedSystem {
 public:
  BandedSystem(Index n, Index lower, Index upper)
      : n_(n),
        lower_(std::min(lower, n - 1)),
        upper_(std::min(upper, n - 1)),
        width_(2 * lower_ + upper_ + 1),
        entries_(static_cast<std::size_t>(n) * static_cast<std::size_t>(width_), R(0)),
        pivots_(static_cast<std::size_t>(n)) {}

  [[nodiscard]] Index size() const { return n_; }

  /// The entry (i, j), i - lower <= j <= i + upper. \pre not factored yet.
  [[nodiscard]] R& at(Index i, Index j) { return entries_[place(i, j)]; }

  /// False if the matrix is singular (in floating point: a column of nothing but zeros was met);
  /// then it must not be solved with.
  [[nodiscard]] bool factor() {
    for (Index k = 0; k < n_; ++k) {
      const Index end = std::min(n_ - 1, k + lower_);
      Index pivot = k;
      for (Index i = k; i <= end; ++i)
        if (better(at(i, k), at(pivot, k))) pivot = i;
      if (at(pivot, k) == R(0)) return false;
      pivots_[static_cast<std::size_t>(k)] = pivot;
      const Index last = std::min(n_ - 1, k + lower_ + upper_);
      if (pivot != k)
        for (Index j = k; j <= last; ++j) std::swap(at(pivot, j), at(k, j));
      for (Index i = k + 1; i <= end; ++i) {
        const R factor = at(i, k) / at(k, k);
        at(i, k) = factor;
        if (factor == R(0)) continue;
        for (Index j = k + 1; j <= last; ++j) at(i, j) = at(i, j) - factor * at(k, j);
      }
    }
    return true;
  }

  /// Solves n numbers in place.
  void solve(R* x) const {
    std::vector<R*> rows;
    for (Index i = 0; i < n_; ++i) rows.push_back(x + i);
    solve(rows, 1);
  }

  /// Solves `width` right-hand sides in place, unknown i of all of them being rows[i][0..width-1].
  /// The same operations on each, whatever the width.
  void solve(const std::vector<R*>& rows, Index width) const {
    const auto row = [&rows](Index i) { return rows[static_cast<std::size_t>(i)]; };
    const auto subtract = [width](R* target, const R& factor, const R* source) {
      if (factor == R(0)) return;
      for (Index c = 0; c < width; ++c) target[c] = target[c] - factor * source[c];
    };
    for (Index k = 0; k < n_; ++k) {
      const Index pivot = pivots_[static_cast<std::size_t>(k)];
      if (pivot != k) std::swap_ranges(row(k), row(k) + width, row(pivot));
      const Index end = std::min(n_ - 1, k + lower_);
      for (Index i = k + 1; i <= end; ++i) subtract(row(i), get(i, k), row(k));
    }
    for (Index k = n_ - 1; k >= 0; --k) {
      const Index last = std::min(n_ - 1, k + lower_ + upper_);
      for (Index j = k + 1; j <= last; ++j) subtract(row(k), get(k, j), row(j));
      const R& diagonal = get(k, k);
      for (Index c = 0; c < width; ++c) row(k)[c] = row(k)[c] / diagonal;
    }
  }

 private:
  // Row i holds the columns i - lower .. i + lower + upper (the last ones for the fill-in).
  [[nodiscard]] std::size_t place(Index i, Index j) const {
    return static_cast<std::size_t>(i * width_ + j - i + lower_);
  }
  [[nodiscard]] const R& get(Index i, Index j) const { return entries_[place(i, j)]; }

  [[nodiscard]] static bool better(const R& a, const R& b) {
    if constexpr (std::is_floating_point_v<R>)
      return std::abs(a) > std::abs(b);
    else
      return b == R(0) && !(a == R(0));
  }

  Index n_;
  Index lower_;
  Index upper_;
  Index width_;
  std::vector<R> entries_;
  std::vector<Index> pivots_;
};

}  // namespace arete
