// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "arete/reverse/local_problem.h"

namespace arete::local {

/// Binary schemes of five coefficients, such as the cubic B-spline: an odd sample lies between two
/// coarse ones, o_j = b c_j + b' c_{j+1}, an even one reads three, e_j = l c_{j-1} + m c_j + r
/// c_{j+1}. Putting the odd samples for the outer coarse ones leaves
///
///     c_j = (e_j - (l/b) o_{j-1} - (r/b') o_j) / (m - l b'/b - r b/b');
///
/// for the cubic B-spline 2 e_j - (o_{j-1} + o_j)/2. At an open end l, m, r are those of the row
/// with its ghosts put in. \pre both b and b' are not zero
template <class R>
[[nodiscard]] std::optional<LocalReverse<R>> five_coefficients(const Problem<R>& p) {
  const int center = p.mask.first() + 2;
  const R b = p.a(center + 1);
  const R b1 = p.a(center - 1);
  const Index n = p.level.coarse_count;
  SparseRows<R> analysis(p.level.rows.count());
  std::vector<std::uint8_t> special(static_cast<std::size_t>(p.level.rows.count()), 0);
  std::vector<Taps<R>> lifting(special.size());
  for (Index j = 0; j < n; ++j) {
    R left = p.a(center + 2);
    R middle = p.a(center);
    R right = p.a(center - 2);
    const auto fold = [&](Index ghost, R& weight) {
      const R outer = std::exchange(weight, R(0));
      for (const auto& part : ghost_sample<R>(p.boundary, ghost, n)) {
        R& target = part.col == j ? middle : part.col < j ? left : right;
        target = target + outer * part.weight;
      }
    };
    if (!p.level.closed && j == 0) fold(-1, left);
    if (!p.level.closed && j == n - 1) fold(n, right);
    const auto even = p.place(2 * j + center);
    const auto before = p.place(2 * j + center - 1);
    const auto after = p.place(2 * j + center + 1);
    const R pivot = middle - left * b1 / b - right * b / b1;
    if (!even || pivot == R(0)) return std::nullopt;
    typename SparseRows<R>::Row row{{*even, R(1) / pivot}};
    for (const auto& [odd, weight] :
         {std::pair{before, R(left / b)}, std::pair{after, R(right / b1)}}) {
      if (weight == R(0)) continue;
      if (!odd) return std::nullopt;
      row.push_back({*odd, R(0) - weight / pivot});
      lifting[static_cast<std::size_t>(*even)].push_back({*odd, weight});
    }
    analysis.push_row(std::move(row));
    special[static_cast<std::size_t>(*even)] = 1;
  }
  return with_residuals(p, std::move(analysis), special,
                        [&](Index i) { return lifting[static_cast<std::size_t>(i)]; });
}

}  // namespace arete::local
