// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

#include "arete/reverse/sparse_rows.h"

namespace arete {

/// L D L^T of the Gram matrix A^T A, kept within its envelope: row i is stored from its first
/// non-zero column to the diagonal. For a banded A (an open axis) that is the band; for a closed
/// axis, whose band wraps around, the last rows are full, and everything still costs O(n b).
///
/// Works over any field: exact over rationals, and stable in floating point without pivoting, for
/// the matrix is positive definite whenever the columns of A are independent.
/// Cost: O(n b^2) to factor, O(n b) a lane to solve. (George and Liu, Computer Solution of Large
/// Sparse Positive Definite Systems, 1981, chapter 4.)
template <class R>
class EnvelopeLdlt {
 public:
  explicit EnvelopeLdlt(const SparseRows<R>& a) : first_(static_cast<std::size_t>(a.cols())) {
    plan(a);
    add_products(a);
    factor();
  }

  /// The first column of A that depends on those before it (in floating point: almost); nothing
  /// when the columns are independent.
  [[nodiscard]] std::optional<Index> dependent_column() const { return dependent_; }

  /// Solves in place. \pre there is no dependent column.
  void solve(Lines<R> x) const {
    const Index n = static_cast<Index>(first_.size());
    for (Index i = 0; i < n; ++i)
      for (Index k = first(i); k < i; ++k) add_line(x[i], x[k], R(0) - at(i, k), x.lanes);
    for (Index i = n; i-- > 0;) {
      const R diagonal = at(i, i);
      R* line = x[i];
      for (Index c = 0; c < x.lanes; ++c) line[c] = line[c] / diagonal;
    }
    for (Index i = n; i-- > 0;)
      for (Index k = first(i); k < i; ++k) add_line(x[k], x[i], R(0) - at(i, k), x.lanes);
  }

 private:
  [[nodiscard]] Index first(Index i) const { return first_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] R& at(Index i, Index k) {
    return entries_[start_[static_cast<std::size_t>(i)] + static_cast<std::size_t>(k - first(i))];
  }
  [[nodiscard]] const R& at(Index i, Index k) const {
    return entries_[start_[static_cast<std::size_t>(i)] + static_cast<std::size_t>(k - first(i))];
  }

  void plan(const SparseRows<R>& a) {
    for (Index i = 0; i < a.cols(); ++i) first_[static_cast<std::size_t>(i)] = i;
    for (Index r = 0; r < a.rows(); ++r) {
      const auto row = a.row(r);
      // Columns of a row are in order: the first one is the lowest.
      for (const auto& entry : row) {
        Index& lowest = first_[static_cast<std::size_t>(entry.col)];
        lowest = std::min(lowest, row.front().col);
      }
    }
    std::size_t size = 0;
    for (Index i = 0; i < a.cols(); ++i) {
      start_.push_back(size);
      size += static_cast<std::size_t>(i - first(i) + 1);
    }
    entries_.assign(size, R(0));
  }

  void add_products(const SparseRows<R>& a) {
    for (Index r = 0; r < a.rows(); ++r) {
      const auto row = a.row(r);
      for (std::size_t i = 0; i < row.size(); ++i)
        for (std::size_t k = 0; k <= i; ++k) {
          R& entry = at(row[i].col, row[k].col);
          entry = entry + row[i].weight * row[k].weight;
        }
    }
  }

  // Row by row; within a row first U = L D, then L.
  void factor() {
    const Index n = static_cast<Index>(first_.size());
    for (Index i = 0; i < n; ++i) {
      const R before = at(i, i);
      for (Index k = first(i); k < i; ++k) {
        R sum = at(i, k);
        for (Index j = std::max(first(i), first(k)); j < k; ++j) sum = sum - at(i, j) * at(k, j);
        at(i, k) = sum;
      }
      R diagonal = before;
      for (Index k = first(i); k < i; ++k) {
        const R scaled = at(i, k) / at(k, k);
        diagonal = diagonal - at(i, k) * scaled;
        at(i, k) = scaled;
      }
      at(i, i) = diagonal;
      if (!positive(diagonal, before)) {
        dependent_ = i;
        return;
      }
    }
  }

  // Whether what is left of a diagonal entry is more than rounding.
  [[nodiscard]] static bool positive(const R& left, const R& before) {
    if constexpr (std::is_floating_point_v<R>)
      return left > before * (64 * std::numeric_limits<R>::epsilon());
    else
      return left > R(0);
  }

  std::vector<Index> first_;
  std::vector<std::size_t> start_;
  std::vector<R> entries_;
  std::optional<Index> dependent_;
};

}  // namespace arete
