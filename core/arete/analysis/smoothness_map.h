// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "arete/analysis/smoothness.h"

namespace arete {

/// What is known at one point of a parameter plane.
struct MapCell {
  bool valid = false;         ///< there is a scheme for these parameters
  int certified = -1;         ///< largest certified order, -1: none
  bool refuted_next = false;  ///< the order above it is refuted; otherwise it is undecided
  bool stable = true;         ///< shifts proved stable
  double hoelder_lower = 0;   ///< proved lower bound of the exponent (<= 0: none)
};

/// Options cheap enough for ten thousands of points: norms to power 4, short words, no polytopes.
[[nodiscard]] SmoothnessOptions map_options(int max_power = 4);

/// analyze_smoothness at every point of a grid, on all cores; points left undecided get a second,
/// more thorough look. Cell (column i, row j) is at
/// [j * xs.size() + i]. `mask_at` is called from several threads and returns nothing where there is
/// no scheme; `progress` (may be empty) is told the number of finished cells from any thread and
/// stops the work by returning false (the rest stays invalid).
[[nodiscard]] std::vector<MapCell> smoothness_map(
    const std::vector<Rational>& xs, const std::vector<Rational>& ys,
    const std::function<std::optional<Mask>(const Rational& x, const Rational& y)>& mask_at,
    const SmoothnessOptions& options = map_options(),
    const std::function<bool(std::size_t done)>& progress = {});

}  // namespace arete
