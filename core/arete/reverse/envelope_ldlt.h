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
/// Cost: O(n b^2) to factor; its recurrences have O(n b) entries. (George and Liu, Computer
/// Solution of Large Sparse Positive Definite Systems, 1981, chapter 4.)
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

  /// L y = M f as a recurrence: row i gives y_i from f stacked upon y_0..y_{i-1}.
  /// \pre there is no dependent column, and M has as many rows as A has columns.
  [[nodiscard]] SparseRows<R> forward(const SparseRows<R>& m) const {
    SparseRows<R> rows(m.cols() + m.rows());
    for (Index i = 0; i < m.rows(); ++i) {
      auto row = m.row(i);
      for (Index k = first(i); k < i; ++k) row.push_back({m.cols() + k, R(0) - at(i, k)});
      rows.push_row(std::move(row));
    }
    return rows;
  }

  /// D L^T x = y as a recurrence: row i gives x_i from y stacked upon x_{i+1}..x_{n-1}.
  /// \pre there is no dependent column
  [[nodiscard]] SparseRows<R> backward() const {
    const Index n = static_cast<Index>(first_.size());
    std::vector<typename SparseRows<R>::Row> columns(static_cast<std::size_t>(n));
    for (Index i = 0; i < n; ++i) {
      columns[static_cast<std::size_t>(i)].push_back({i, R(1) / at(i, i)});
      for (Index k = first(i); k < i; ++k)
        columns[static_cast<std::size_t>(k)].push_back({n + i, R(0) - at(i, k)});
    }
    SparseRows<R> rows(2 * n);
    for (auto& row : columns) rows.push_row(std::move(row));
    return rows;
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
