// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "arete/reverse/lines.h"

namespace arete {

/// A matrix with few entries in each row, over any ring: a step of subdivision along one axis, a
/// filter, or its reverse. Rows are made once, in order, and applied to lines.
template <class R>
class SparseRows {
 public:
  struct Entry {
    Index col = 0;
    R weight{};
  };
  using Row = std::vector<Entry>;

  /// No rows yet. \pre cols >= 0
  explicit SparseRows(Index cols) : cols_(cols), start_{0} {}

  /// Adds a row; entries of the same column are added up, zeros left out, columns put in order.
  /// \pre 0 <= col < cols()
  void push_row(Row row) {
    std::stable_sort(row.begin(), row.end(),
                     [](const Entry& a, const Entry& b) { return a.col < b.col; });
    for (std::size_t i = 0; i < row.size();) {
      Entry sum = row[i];
      for (++i; i < row.size() && row[i].col == sum.col; ++i)
        sum.weight = sum.weight + row[i].weight;
      if (sum.weight == R(0)) continue;
      columns_.push_back(sum.col);
      weights_.push_back(sum.weight);
    }
    most_taps_ = std::max(most_taps_, columns_.size() - start_.back());
    start_.push_back(columns_.size());
  }

  [[nodiscard]] Index rows() const { return static_cast<Index>(start_.size()) - 1; }
  [[nodiscard]] Index cols() const { return cols_; }
  [[nodiscard]] std::size_t most_taps() const { return most_taps_; }

  [[nodiscard]] Row row(Index i) const {
    Row entries;
    for (std::size_t k = begin(i); k < begin(i + 1); ++k)
      entries.push_back({columns_[k], weights_[k]});
    return entries;
  }

  /// The column that row i is a mere copy of (one entry, of weight 1); -1 for any other row.
  [[nodiscard]] Index copied_column(Index i) const {
    const std::size_t k = begin(i);
    return begin(i + 1) == k + 1 && weights_[k] == R(1) ? columns_[k] : Index{-1};
  }

  /// The rows `chosen`, in that order.
  [[nodiscard]] SparseRows selected(const std::vector<Index>& chosen) const {
    SparseRows result(cols_);
    for (const Index i : chosen) result.push_row(row(i));
    return result;
  }

  /// out = A (x stacked upon y), where x.count + y.count = cols(). Rows of `out` are made in order
  /// and must not overlap the lines that they or later rows read.
  void multiply(Lines<const R> x, Lines<const R> y, Lines<R> out) const {
    std::vector<const R*> taps(most_taps_);
    for (Index i = 0; i < rows(); ++i) multiply_row(i, x, y, out[i], taps);
  }
  void multiply(Lines<const R> x, Lines<R> out) const { multiply(x, x.part(0, 0), out); }
  /// Row i goes to out[places[i]]; other lines of `out` are left alone.
  void multiply(Lines<const R> x, Lines<const R> y, const std::vector<Index>& places,
                Lines<R> out) const {
    std::vector<const R*> taps(most_taps_);
    for (Index i = 0; i < rows(); ++i)
      multiply_row(i, x, y, out[places[static_cast<std::size_t>(i)]], taps);
  }

  /// A recurrence: y_i = row i applied to (x stacked upon y), i = 0, 1, ...; row i must read no
  /// y_j with j >= i. The y must not overlap x.
  void recur(Lines<const R> x, Lines<R> y) const { multiply(x, y, y); }
  /// The same from the last row to the first; row i must read no y_j with j <= i.
  void recur_back(Lines<const R> x, Lines<R> y) const {
    std::vector<const R*> taps(most_taps_);
    for (Index i = rows(); i-- > 0;) multiply_row(i, x, y, y[i], taps);
  }

  /// The lines of row i alone, into `out`.
  void multiply_row(Index i, Lines<const R> x, R* out) const {
    std::vector<const R*> taps(most_taps_);
    multiply_row(i, x, x.part(0, 0), out, taps);
  }

  /// A^T: its sums run over the rows of A in order.
  [[nodiscard]] SparseRows transposed() const {
    std::vector<Row> columns(static_cast<std::size_t>(cols_));
    for (Index i = 0; i < rows(); ++i)
      for (const auto& [col, weight] : row(i))
        columns[static_cast<std::size_t>(col)].push_back({i, weight});
    SparseRows result(rows());
    for (Row& column : columns) result.push_row(std::move(column));
    return result;
  }

 private:
  [[nodiscard]] std::size_t begin(Index i) const { return start_[static_cast<std::size_t>(i)]; }

  void multiply_row(Index i, Lines<const R> x, Lines<const R> y, R* out,
                    std::vector<const R*>& taps) const {
    const std::size_t first = begin(i);
    const std::size_t count = begin(i + 1) - first;
    for (std::size_t k = 0; k < count; ++k) {
      const Index col = columns_[first + k];
      taps[k] = col < x.count ? x[col] : y[col - x.count];
    }
    weighted_sum(out, taps.data(), weights_.data() + first, static_cast<int>(count), x.lanes);
  }

  Index cols_;
  std::vector<std::size_t> start_;
  std::vector<Index> columns_;
  std::vector<R> weights_;
  std::size_t most_taps_ = 0;
};

}  // namespace arete
