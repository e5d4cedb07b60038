// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "arete/reverse/synthesis_rows.h"

namespace arete {

/// Exact reverse of one step along one axis by short filters, three matrices:
///
///     coarse  = analysis fine
///     details = detail (fine stacked upon coarse)
///     fine    = synthesis (coarse stacked upon details)
///
/// Every coarse sample reads a few fine ones, and reconstruction is exact for ANY fine samples.
/// Fine samples that came out of the step have coarse = what they came from and details = 0.
template <class R>
struct LocalReverse {
  SparseRows<R> analysis;
  SparseRows<R> detail;
  SparseRows<R> synthesis;
};

namespace local {

/// What every rule below starts from.
template <class R>
struct Problem {
  const Mask& mask;
  const ReverseLevel& level;
  Boundary boundary;
  const SparseRows<R>& s;  ///< synthesis_rows of the level

  /// Where the scheme's sample k is among the fine ones; nothing if it is not there.
  [[nodiscard]] std::optional<Index> place(Index k) const {
    const Index count = level.rows.count();
    if (level.closed) return floor_modulo(k, count);
    const Index i = k - level.rows.first;
    return i >= 0 && i < count ? std::optional<Index>(i) : std::nullopt;
  }
  [[nodiscard]] R a(int k) const { return mask[k].convert_to<R>(); }
  [[nodiscard]] static Index floor_modulo(Index k, Index n) { return ((k % n) + n) % n; }
};

/// The common end of the rules: coarse samples are known as filters; a row of `special` has its
/// own synthesis beside S c (entries over details), every other row keeps its residual.
template <class R>
[[nodiscard]] LocalReverse<R> with_residuals(const Problem<R>& p, SparseRows<R> analysis,
                                             const std::vector<std::uint8_t>& special,
                                             auto&& special_details) {
  const Index n = p.level.coarse_count;
  const Index rows = p.level.rows.count();
  std::vector<Index> detail_of(static_cast<std::size_t>(rows), -1);
  SparseRows<R> detail(rows + n);
  for (Index i = 0; i < rows; ++i) {
    if (special[static_cast<std::size_t>(i)] != 0) continue;
    detail_of[static_cast<std::size_t>(i)] = detail.rows();
    detail.push_row(residual_row(p.s, i));
  }
  SparseRows<R> synthesis(n + detail.rows());
  for (Index i = 0; i < rows; ++i) {
    auto row = p.s.row(i);
    const Index own = detail_of[static_cast<std::size_t>(i)];
    if (own >= 0)
      row.push_back({n + own, R(1)});
    else
      for (const auto& [fine, weight] : special_details(i))
        row.push_back({n + detail_of[static_cast<std::size_t>(fine)], weight});
    synthesis.push_row(std::move(row));
  }
  return {std::move(analysis), std::move(detail), std::move(synthesis)};
}

template <class R>
using Taps = std::vector<std::pair<Index, R>>;

/// One coarse sample: it is the first fine one.
template <class R>
[[nodiscard]] LocalReverse<R> single_sample(const Problem<R>& p) {
  SparseRows<R> analysis(p.level.rows.count());
  analysis.push_row({{0, R(1)}});
  std::vector<std::uint8_t> special(static_cast<std::size_t>(p.level.rows.count()), 0);
  special[0] = 1;
  return with_residuals(p, std::move(analysis), special, [](Index) { return Taps<R>{}; });
}

}  // namespace local
}  // namespace arete
