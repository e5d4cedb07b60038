// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>

#include "arete/reverse/envelope_ldlt.h"

namespace arete {

/// Solves A^T A x = M f for many lines f at once: two recurrences along the lines, down with
/// L y = M f, up with D L^T x = y. M is taken into the first one, so that every y and every x is
/// one weighted sum of lines. Over any field.
template <class R>
class NormalEquations {
 public:
  /// \pre M has as many rows as A has columns.
  NormalEquations(const SparseRows<R>& a, const SparseRows<R>& m)
      : NormalEquations(EnvelopeLdlt<R>(a), m) {}

  /// The first column of A that depends on those before it (in floating point: almost); nothing
  /// when the columns are independent.
  [[nodiscard]] std::optional<Index> dependent_column() const { return dependent_; }

  /// \pre there is no dependent column; x overlaps no line of f.
  void solve(Lines<const R> f, Lines<R> x) const {
    LineBuffer<R> y(down_.rows(), f.lanes);
    down_.recur(f, y.lines());
    up_.recur_back(y.lines(), x);
  }

 private:
  NormalEquations(const EnvelopeLdlt<R>& factor, const SparseRows<R>& m)
      : dependent_(factor.dependent_column()),
        down_(dependent_ ? SparseRows<R>(0) : factor.forward(m)),
        up_(dependent_ ? SparseRows<R>(0) : factor.backward()) {}

  std::optional<Index> dependent_;
  SparseRows<R> down_;
  SparseRows<R> up_;
};

}  // namespace arete
