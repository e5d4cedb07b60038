// SPDX-License-Identifier: MIT
#pragma once

#include "arete/reverse/local_problem.h"

namespace arete::local {

/// The index s with a_s = 1 and a_{s + m k} = 0 for every other k: the scheme interpolates, its new
/// sample m j + s is the old sample j. Nothing if there is none.
[[nodiscard]] inline std::optional<int> interpolated_phase(const Mask& mask) {
  for (int s = mask.first(); s <= mask.last(); ++s) {
    if (mask[s] != 1) continue;
    bool alone = true;
    for (int k = mask.first(); k <= mask.last(); ++k)
      alone = alone && (k == s || (k - s) % mask.arity() != 0 || mask[k] == 0);
    if (alone) return s;
  }
  return std::nullopt;
}

/// Interpolatory schemes of any arity: the coarse samples are fine samples, the details are the
/// residuals of the others.
template <class R>
[[nodiscard]] std::optional<LocalReverse<R>> interpolatory(const Problem<R>& p) {
  const int s = *interpolated_phase(p.mask);
  SparseRows<R> analysis(p.level.rows.count());
  std::vector<std::uint8_t> special(static_cast<std::size_t>(p.level.rows.count()), 0);
  for (Index j = 0; j < p.level.coarse_count; ++j) {
    const auto row = p.place(p.mask.arity() * j + s);
    if (!row) return std::nullopt;
    analysis.push_row({{*row, R(1)}});
    special[static_cast<std::size_t>(*row)] = 1;
  }
  return with_residuals(p, std::move(analysis), special, [](Index) { return Taps<R>{}; });
}

}  // namespace arete::local
