// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "arete/reverse/envelope_ldlt.h"

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
  LeastSquaresReverse(SparseRows<R> s, std::vector<Index> anchors)
      : anchors_(std::move(anchors)),
        rest_(others(s.rows(), anchors_)),
        s_(std::move(s)),
        s_anchors_(s_.selected(anchors_)),
        s_rest_(s_.selected(rest_)),
        s_transposed_(s_.transposed()),
        s_rest_transposed_(s_rest_.transposed()),
        gram_(s_),
        anchor_gram_(s_anchors_) {}

  /// False when S or its anchors' part does not have independent columns; then nothing else works.
  [[nodiscard]] bool regular() const {
    return !gram_.dependent_column() && !anchor_gram_.dependent_column();
  }
  [[nodiscard]] Index detail_count() const { return static_cast<Index>(rest_.size()); }

  void analyse(Lines<const R> fine, Lines<R> coarse, Lines<R> details) const {
    s_transposed_.multiply(fine, coarse);
    gram_.solve(coarse);
    s_rest_.multiply(coarse, details);
    for (Index i = 0; i < details.count; ++i) {
      const R* sample = fine[rest_[static_cast<std::size_t>(i)]];
      R* detail = details[i];
      for (Index c = 0; c < details.lanes; ++c) detail[c] = sample[c] - detail[c];
    }
  }

  void synthesise(Lines<const R> coarse, Lines<const R> details, Lines<R> fine) const {
    LineBuffer<R> solution(s_.cols(), fine.lanes);
    LineBuffer<R> anchor_part(s_.cols(), fine.lanes);
    s_rest_transposed_.multiply(details, solution.lines());
    anchor_gram_.solve(solution.lines());
    s_anchors_.multiply(solution.lines(), anchor_part.lines());
    s_.multiply(coarse, fine);
    for (Index i = 0; i < details.count; ++i)
      add_line(fine[rest_[static_cast<std::size_t>(i)]], details[i], R(1), fine.lanes);
    for (Index i = 0; i < s_.cols(); ++i)
      add_line(fine[anchors_[static_cast<std::size_t>(i)]], anchor_part.lines()[i], R(-1),
               fine.lanes);
  }

 private:
  static std::vector<Index> others(Index rows, const std::vector<Index>& anchors) {
    std::vector<Index> rest;
    for (Index i = 0; i < rows; ++i)
      if (!std::binary_search(anchors.begin(), anchors.end(), i)) rest.push_back(i);
    return rest;
  }

  std::vector<Index> anchors_;
  std::vector<Index> rest_;
  SparseRows<R> s_;
  SparseRows<R> s_anchors_;
  SparseRows<R> s_rest_;
  SparseRows<R> s_transposed_;
  SparseRows<R> s_rest_transposed_;
  EnvelopeLdlt<R> gram_;
  EnvelopeLdlt<R> anchor_gram_;
};

}  // namespace arete
