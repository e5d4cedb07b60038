// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "arete/reverse/local_problem.h"

namespace arete::local {

/// Corner cutting, f_{2j} = (1-u) c_j + u c_{j+1}, f_{2j+1} = v c_j + (1-v) c_{j+1}, u + v != 1:
/// each pair of fine samples determines both coarse ones, so each coarse sample is estimated from
/// either side,
///
///     c_j^+ = ((1-v) f_{2j} - u f_{2j+1})/(1-u-v),   c_j^- = ((1-u) f_{2j-1} - v
///     f_{2j-2})/(1-u-v);
///
/// c_j is their mean and d_j half their difference, so that
///
///     f_{2j}   = (1-u) (c_j + d_j) + u (c_{j+1} - d_{j+1}),
///     f_{2j+1} =   v   (c_j + d_j) + (1-v) (c_{j+1} - d_{j+1}).
///
/// For Chaikin c_j = (-1, 3, 3, -1)/4, which is also the least-squares filter of that width. At an
/// open end there is one estimate and no detail; a fine sample beyond the last pair keeps its
/// residual.
template <class R>
class CornerCutting {
 public:
  explicit CornerCutting(const Problem<R>& problem)
      : p_(problem),
        n_(problem.level.coarse_count),
        rows_(problem.level.rows.count()),
        u_(problem.a(problem.mask.first())),
        v_(problem.a(problem.mask.last())),
        pairs_(static_cast<std::size_t>(n_)),
        residual_of_(static_cast<std::size_t>(rows_), -1),
        detail_of_(static_cast<std::size_t>(n_), -1),
        analysis_(rows_),
        detail_(rows_ + n_) {}

  [[nodiscard]] std::optional<LocalReverse<R>> build() {
    const Index paired_end = find_pairs();
    const auto& first = pairs_.front();
    if (first && !p_.level.closed) add_residuals(0, (*first)[0]);
    for (Index j = 0; j < n_; ++j)
      if (!add_coarse_sample(j)) return std::nullopt;
    add_residuals(paired_end, rows_);
    return LocalReverse<R>{std::move(analysis_), std::move(detail_), synthesis()};
  }

 private:
  using Row = typename SparseRows<R>::Row;
  using Pair = std::array<Index, 2>;  // places of f_{2j} and f_{2j+1}

  // Returns where the samples behind the last pair begin.
  Index find_pairs() {
    if (p_.level.closed) {
      for (Index j = 0; j < n_; ++j) *add_pair(j);
      return rows_;
    }
    Index end = 0;
    for (Index j = 0; j + 1 < n_; ++j)
      if (const auto pair = add_pair(j)) end = (*pair)[1] + 1;
    return end;
  }

  std::optional<Pair> add_pair(Index j) {
    const auto even = p_.place(2 * j + p_.mask.first() + 2);
    const auto odd = p_.place(2 * j + p_.mask.first() + 3);
    if (!even || !odd) return std::nullopt;
    return pairs_[static_cast<std::size_t>(j)] = Pair{*even, *odd};
  }

  void add_residuals(Index from, Index to) {
    for (Index i = from; i < to; ++i) {
      residual_of_[static_cast<std::size_t>(i)] = detail_.rows();
      detail_.push_row(residual_row(p_.s, i));
    }
  }

  // The estimates of c_j from the pair behind it and the pair before it, as far as there are any.
  bool add_coarse_sample(Index j) {
    const R spread = R(1) - u_ - v_;
    const Index before = j > 0 ? j - 1 : n_ - 1;
    Row plus;
    Row minus;
    if (const auto& pair = pairs_[static_cast<std::size_t>(j)])
      plus = {{(*pair)[0], (R(1) - v_) / spread}, {(*pair)[1], (R(0) - u_) / spread}};
    if (const auto& pair = pairs_[static_cast<std::size_t>(before)];
        pair && (j > 0 || p_.level.closed))
      minus = {{(*pair)[1], (R(1) - u_) / spread}, {(*pair)[0], (R(0) - v_) / spread}};
    if (plus.empty() && minus.empty()) return false;
    if (plus.empty() || minus.empty()) {
      analysis_.push_row(plus.empty() ? minus : plus);
      return true;
    }
    Row mean;
    Row half_difference;
    for (const auto& [col, weight] : plus) {
      mean.push_back({col, weight / R(2)});
      half_difference.push_back({col, weight / R(2)});
    }
    for (const auto& [col, weight] : minus) {
      mean.push_back({col, weight / R(2)});
      half_difference.push_back({col, R(0) - weight / R(2)});
    }
    analysis_.push_row(std::move(mean));
    detail_of_[static_cast<std::size_t>(j)] = detail_.rows();
    detail_.push_row(std::move(half_difference));
    return true;
  }

  [[nodiscard]] SparseRows<R> synthesis() const {
    std::vector<Row> rows;
    for (Index i = 0; i < rows_; ++i) {
      rows.push_back(p_.s.row(i));
      const Index own = residual_of_[static_cast<std::size_t>(i)];
      if (own >= 0) rows.back().push_back({n_ + own, R(1)});
    }
    for (Index j = 0; j < n_; ++j) {
      const auto& pair = pairs_[static_cast<std::size_t>(j)];
      if (!pair) continue;
      Row& even = rows[static_cast<std::size_t>((*pair)[0])];
      Row& odd = rows[static_cast<std::size_t>((*pair)[1])];
      const Index own = detail_of_[static_cast<std::size_t>(j)];
      const Index next = detail_of_[static_cast<std::size_t>(j + 1 < n_ ? j + 1 : 0)];
      if (own >= 0) {
        even.push_back({n_ + own, R(1) - u_});
        odd.push_back({n_ + own, v_});
      }
      if (next >= 0) {
        even.push_back({n_ + next, R(0) - u_});
        odd.push_back({n_ + next, v_ - R(1)});
      }
    }
    SparseRows<R> result(n_ + detail_.rows());
    for (Row& row : rows) result.push_row(std::move(row));
    return result;
  }

  const Problem<R>& p_;
  Index n_;
  Index rows_;
  R u_;
  R v_;
  std::vector<std::optional<Pair>> pairs_;
  std::vector<Index> residual_of_;
  std::vector<Index> detail_of_;
  SparseRows<R> analysis_;
  SparseRows<R> detail_;
};

}  // namespace arete::local
