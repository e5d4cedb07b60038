// SPDX-License-Identifier: MIT
#pragma once

#include "arete/reverse/reverse_level.h"
#include "arete/reverse/sparse_rows.h"

namespace arete {

/// The matrix S of one step of subdivision: fine sample k = rows.first + i is row i, coarse samples
/// 0..coarse_count-1 are the columns. A coarse index beyond them is what `ghost(index)` says: a
/// SparseRows<R>::Row over the real ones.
template <class R, class Ghost>
[[nodiscard]] SparseRows<R> synthesis_rows(const Mask& mask, Index coarse_count, IndexRange rows,
                                           Ghost&& ghost) {
  const PhasedRule<R> rule(LevelRule{mask.arity(), mask.symbol()});
  SparseRows<R> result(coarse_count);
  for (Index k = rows.first; k <= rows.last; ++k) {
    const Index q = floor_divide(k, rule.arity);
    const PhaseStencil<R>& stencil = rule.phases[static_cast<std::size_t>(k - rule.arity * q)];
    typename SparseRows<R>::Row row;
    for (std::size_t i = 0; i < stencil.weights.size(); ++i) {
      const Index j = q + stencil.first + static_cast<Index>(i);
      if (j >= 0 && j < coarse_count) {
        row.push_back({j, stencil.weights[i]});
        continue;
      }
      for (auto& part : ghost(j)) row.push_back({part.col, stencil.weights[i] * part.weight});
    }
    result.push_row(std::move(row));
  }
  return result;
}

/// A ghost sample as the boundary makes it. \pre boundary is not `none`
template <class R>
[[nodiscard]] typename SparseRows<R>::Row ghost_sample(Boundary boundary, Index index,
                                                       Index count) {
  const Continuation from = continued(boundary, index, count);
  if (from.steps == 0) return {{from.near, R(1)}};
  const R steps(static_cast<int>(from.steps));
  return {{from.near, R(1) + steps}, {from.far, R(0) - steps}};
}

/// The matrix of a reverse level.
template <class R>
[[nodiscard]] SparseRows<R> synthesis_rows(const Mask& mask, const ReverseLevel& level,
                                           Boundary boundary) {
  return synthesis_rows<R>(mask, level.coarse_count, level.rows, [&](Index j) {
    return ghost_sample<R>(boundary, j, level.coarse_count);
  });
}

/// Fine sample `row` minus its prediction: row `row` of (I | -S), of fine stacked upon coarse.
template <class R>
[[nodiscard]] typename SparseRows<R>::Row residual_row(const SparseRows<R>& s, Index row) {
  typename SparseRows<R>::Row entries{{row, R(1)}};
  for (const auto& entry : s.row(row))
    entries.push_back({s.rows() + entry.col, R(0) - entry.weight});
  return entries;
}

}  // namespace arete
