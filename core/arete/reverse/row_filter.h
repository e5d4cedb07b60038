// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "arete/field/boundary.h"
#include "arete/reverse/sparse_rows.h"

namespace arete {

/// A matrix of SparseRows applied to one row of samples that lie side by side, where SparseRows
/// itself wants many lines. Far from the ends such a matrix repeats itself: output i + period is
/// output i with its inputs shifted, by `shift_x` in x and `shift_y` in y. Each run of repetitions
/// is one call of the engine's hot loop on the phases of the inputs; what does not repeat is summed
/// alone. The sums are those of SparseRows::multiply, bit for bit.
template <class T>
class RowFilter {
 public:
  struct Period {
    Index outputs = 1;
    Index shift_x = 1;
    Index shift_y = 1;
  };

  /// `x_count`: columns of the matrix that belong to x; the others belong to y.
  RowFilter(const SparseRows<T>& matrix, Index x_count, Period period)
      : period_(period),
        rows_(matrix.rows()),
        x_(x_count, period.shift_x),
        y_(matrix.cols() - x_count, period.shift_y) {
    for (Index residue = 0; residue < std::min(period.outputs, rows_); ++residue)
      add_runs(matrix, residue);
  }

  /// Memory that apply() works in, to be kept from row to row; one a thread.
  struct Workspace {
    std::vector<T> x, y, out;
    std::vector<const T*> taps;
  };

  /// out = A (x stacked upon y).
  void apply(const T* x, const T* y, T* out, Workspace& work) const {
    x_.part(x, work.x);
    y_.part(y, work.y);
    // Outputs of one phase lie side by side until all are there.
    const Index stride = ceil_divide(rows_, period_.outputs);
    const bool phased = period_.outputs > 1;
    if (phased) work.out.resize(static_cast<std::size_t>(stride * period_.outputs));
    for (const Run& run : runs_) {
      work.taps.clear();
      for (const Index column : run.columns)
        work.taps.push_back(column < x_.count ? x_.at(x, work.x, column)
                                              : y_.at(y, work.y, column - x_.count));
      T* target = phased ? work.out.data() + (run.first % period_.outputs) * stride +
                               run.first / period_.outputs
                         : out + run.first;
      weighted_sum(target, work.taps.data(), run.weights.data(),
                   static_cast<int>(run.columns.size()), run.count);
    }
    if (phased) join(work.out.data(), stride, out);
  }

 private:
  // Samples parted into phases, so that every shift-th lies beside the next.
  struct Phases {
    Index count;
    Index shift;
    Index stride;
    Phases(Index n, Index by) : count(n), shift(by), stride((n + by - 1) / by) {}

    void part(const T* samples, std::vector<T>& phases) const {
      if (shift == 1 || count == 0) return;
      phases.resize(static_cast<std::size_t>(stride * shift));
      if (shift == 2) {
        T* even = phases.data();
        T* odd = even + stride;
        for (Index i = 0; i < count / 2; ++i) {
          even[i] = samples[2 * i];
          odd[i] = samples[2 * i + 1];
        }
        if (count % 2 != 0) even[stride - 1] = samples[count - 1];
        return;
      }
      for (Index p = 0; p < shift; ++p)
        for (Index i = p, k = 0; i < count; i += shift, ++k)
          phases[static_cast<std::size_t>(p * stride + k)] = samples[i];
    }
    [[nodiscard]] const T* at(const T* samples, const std::vector<T>& phases, Index i) const {
      if (shift == 1) return samples + i;
      return phases.data() + (i % shift) * stride + i / shift;
    }
  };

  // Outputs first, first + period, ...: `count` of them, the first one with these taps.
  struct Run {
    Index first = 0;
    Index count = 0;
    std::vector<Index> columns;
    std::vector<T> weights;
  };

  // Phases back into one row.
  void join(const T* phases, Index stride, T* out) const {
    if (period_.outputs == 2) {
      for (Index i = 0; i < rows_ / 2; ++i) {
        out[2 * i] = phases[i];
        out[2 * i + 1] = phases[stride + i];
      }
      if (rows_ % 2 != 0) out[rows_ - 1] = phases[stride - 1];
      return;
    }
    for (Index p = 0; p < period_.outputs; ++p)
      for (Index i = p, k = 0; i < rows_; i += period_.outputs, ++k)
        out[i] = phases[p * stride + k];
  }

  void add_runs(const SparseRows<T>& matrix, Index residue) {
    for (Index i = residue; i < matrix.rows(); i += period_.outputs) {
      const auto row = matrix.row(i);
      if (!runs_.empty() && runs_.back().first % period_.outputs == residue &&
          continues(runs_.back(), row)) {
        ++runs_.back().count;
        continue;
      }
      Run run{i, 1, {}, {}};
      for (const auto& [col, weight] : row) {
        run.columns.push_back(col);
        run.weights.push_back(weight);
      }
      runs_.push_back(std::move(run));
    }
  }

  [[nodiscard]] bool continues(const Run& run, const typename SparseRows<T>::Row& row) const {
    if (row.size() != run.columns.size()) return false;
    for (std::size_t k = 0; k < row.size(); ++k) {
      const Index shift = run.columns[k] < x_.count ? period_.shift_x : period_.shift_y;
      if (row[k].weight != run.weights[k] || row[k].col != run.columns[k] + shift * run.count ||
          (row[k].col < x_.count) != (run.columns[k] < x_.count))
        return false;
    }
    return true;
  }

  Period period_;
  Index rows_ = 0;
  Phases x_;
  Phases y_;
  std::vector<Run> runs_;
};

/// The rows of something that is asked for more or less in order: the last few are kept, others are
/// made (again).
template <class T>
class RowCache {
 public:
  RowCache(std::size_t kept, Index width) : slots_(kept) {
    for (Slot& slot : slots_) slot.row.resize(static_cast<std::size_t>(width));
  }

  /// Row i; `make(T*)` computes it if it is not kept.
  template <class Make>
  [[nodiscard]] const T* row(Index i, Make&& make) {
    Slot* oldest = &slots_.front();
    for (Slot& slot : slots_) {
      if (slot.number == i) {
        slot.used = ++clock_;
        return slot.row.data();
      }
      if (slot.used < oldest->used) oldest = &slot;
    }
    make(oldest->row.data());
    oldest->number = i;
    oldest->used = ++clock_;
    return oldest->row.data();
  }

 private:
  struct Slot {
    Index number = -1;
    std::uint64_t used = 0;
    std::vector<T> row;
  };
  std::vector<Slot> slots_;
  std::uint64_t clock_ = 0;
};

}  // namespace arete
