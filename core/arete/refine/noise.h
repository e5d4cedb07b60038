// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "arete/refine/level_rule.h"
#include "arete/refine/philox.h"

namespace arete {

/// Random integers for the samples of one row of one level: sums of four uniform 16-bit numbers,
/// less their mean, so bell-shaped, of mean 0 and deviation 1 / noise_unit, at most 131070 in size
/// (exact in float). They depend on seed, level, row and column alone.
struct NoiseRow {
  std::uint64_t seed = 0;
  int level = 0;
  Index row = 0;

  /// The counter that two neighbouring columns, 2 pair and 2 pair + 1, share.
  [[nodiscard]] Philox::Counter counter(Index pair) const;
  [[nodiscard]] Philox::Key key() const;

  /// The number at one column.
  [[nodiscard]] std::int32_t at(Index column) const;
  /// The same for a run of columns.
  void fill(IndexRange columns, std::int32_t* out) const;
};

/// Turns the integers into numbers of deviation 1: sqrt(3) / 2^16.
inline constexpr double noise_unit = 1.7320508075688772 / 65536;

}  // namespace arete
