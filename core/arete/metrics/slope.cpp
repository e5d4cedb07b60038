// SPDX-License-Identifier: MIT
#include "arete/metrics/slope.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace arete {

void slope_degrees(GridView<const double> heights, WorldPoint spacing, Index row, double* out) {
  if (!(spacing.x > 0 && spacing.y > 0 && std::isfinite(spacing.x) && std::isfinite(spacing.y)))
    throw InvalidField("slopes need a positive distance of columns and rows");
  const bool rim = row == 0 || row + 1 >= heights.rows();
  for (Index c = 0; c < heights.cols(); ++c) {
    if (rim || c == 0 || c + 1 >= heights.cols()) {
      out[c] = std::numeric_limits<double>::quiet_NaN();
      continue;
    }
    const auto z = [&](Index i, Index j) { return heights(row + i, c + j); };
    const double east = z(-1, 1) + 2 * z(0, 1) + z(1, 1);
    const double west = z(-1, -1) + 2 * z(0, -1) + z(1, -1);
    const double north = z(-1, -1) + 2 * z(-1, 0) + z(-1, 1);
    const double south = z(1, -1) + 2 * z(1, 0) + z(1, 1);
    const double steepness =
        std::hypot((east - west) / (8 * spacing.x), (north - south) / (8 * spacing.y));
    // The middle has no weight, but a slope at no sample would be none.
    out[c] = std::atan(steepness) * 180 / std::numbers::pi + 0 * z(0, 0);
  }
}

}  // namespace arete
