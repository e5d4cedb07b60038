// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "arete/reverse/normal_equations.h"
#include "arete/reverse/synthesis_rows.h"

namespace arete {

/// The best reverse of f = S c: the coarse samples c that make |f - S c| least,
///
///     S^T S c = S^T f,
///
/// a banded positive definite system solved in O(n). The residual e = f - S c satisfies S^T e = 0,
/// so it is known from all but n of its numbers: details are e without the anchors (see
/// anchor_rows.h), and the anchors' part x solves S_a^T x = -S_rest^T e_rest, by x = S_a y with
/// S_a^T S_a y = -S_rest^T e_rest. Coarse and details are exactly as many numbers as f.
///
/// Works over any field; S may be any matrix of full column rank.
template <class R>
class LeastSquaresReverse {
 public:
  /// `anchors`: s.cols() rows of s, in order, that form an invertible matrix.
  LeastSquaresReverse(const SparseRows<R>& s, const std::vector<Index>& anchors)
      : LeastSquaresReverse(s, anchors, others(s.rows(), anchors)) {}

  /// False when S or its anchors' part does not have independent columns; then nothing else works.
  [[nodiscard]] bool regular() const {
    return !gram_.dependent_column() && !anchor_gram_.dependent_column();
  }
  [[nodiscard]] Index detail_count() const { return detail_.rows(); }

  /// `coarse` and `details` must not overlap `fine`.
  void analyse(Lines<const R> fine, Lines<R> coarse, Lines<R> details) const {
    gram_.solve(fine, coarse);
    detail_.multiply(fine, coarse, details);
  }

  /// `fine` must not overlap `coarse` and `details`.
  void synthesise(Lines<const R> coarse, Lines<const R> details, Lines<R> fine) const {
    LineBuffer<R> solution(coarse.count, fine.lanes);
    anchor_gram_.solve(details, solution.lines());
    rest_.multiply(coarse, details, rest_rows_, fine);
    anchors_.multiply(coarse, solution.lines(), anchor_rows_, fine);
  }

 private:
  LeastSquaresReverse(const SparseRows<R>& s, const std::vector<Index>& anchors,
                      const std::vector<Index>& rest)
      : gram_(s, s.transposed()),
        anchor_gram_(s.selected(anchors), s.selected(rest).transposed()),
        detail_(s.rows() + s.cols()),
        rest_(s.cols() + static_cast<Index>(rest.size())),
        anchors_(2 * s.cols()),
        rest_rows_(rest),
        anchor_rows_(anchors) {
    for (const Index i : rest) {
      detail_.push_row(residual_row(s, i));
      auto row = s.row(i);
      row.push_back({s.cols() + rest_.rows(), R(1)});
      rest_.push_row(std::move(row));
    }
    // anchor_gram_ gives -y, from +S_rest^T e_rest.
    for (const Index i : anchors) {
      auto row = s.row(i);
      for (auto& entry : s.row(i)) row.push_back({s.cols() + entry.col, R(0) - entry.weight});
      anchors_.push_row(std::move(row));
    }
  }

  static std::vector<Index> others(Index rows, const std::vector<Index>& anchors) {
    std::vector<Index> rest;
    for (Index i = 0; i < rows; ++i)
      if (!std::binary_search(anchors.begin(), anchors.end(), i)) rest.push_back(i);
    return rest;
  }

  NormalEquations<R> gram_;         // fine samples to coarse ones
  NormalEquations<R> anchor_gram_;  // details to the -y above
  SparseRows<R> detail_;            // of fine upon coarse
  SparseRows<R> rest_;              // fine samples that are no anchors, of coarse upon details
  SparseRows<R> anchors_;           // and the anchors, of coarse upon -y
  std::vector<Index> rest_rows_;
  std::vector<Index> anchor_rows_;
};

}  // namespace arete
