// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "arete/field/grid.h"

namespace arete {

/// What a sample of a raster stands for: the height at a point, or the mean over a cell. It is
/// carried along and never changes where a sample lies.
enum class Registration { point, area };

/// A position in the raster's own plane: x, y in the units of its reference system.
struct WorldPoint {
  double x = 0;
  double y = 0;
};

/// Where samples lie in the world: the affine map of GDAL, from pixel EDGES to coordinates,
///
///     x = g[0] + P g[1] + L g[2],   y = g[3] + P g[4] + L g[5],
///
/// where the sample (row, col) lies at P = col + 1/2, L = row + 1/2, for point registration too.
struct Georeference {
  std::array<double, 6> affine{0, 1, 0, 0, 0, 1};
  Registration registration = Registration::area;

  /// The coordinates of the sample (row, col); fractions and indices outside are meant literally.
  [[nodiscard]] WorldPoint position(double row, double col) const {
    const double p = col + 0.5;
    const double l = row + 0.5;
    return {affine[0] + p * affine[1] + l * affine[2], affine[3] + p * affine[4] + l * affine[5]};
  }
};

/// Where the samples of a refined axis lie, in samples of the input: sample i at first + i spacing.
struct AxisPlacement {
  Index count = 0;
  double first = 0;
  double spacing = 1;
};

/// The georeference of a raster whose rows and columns lie as given among those of `coarse`.
/// Exact up to one rounding a term, for rotated and sheared maps too.
[[nodiscard]] inline Georeference refined(const Georeference& coarse, const AxisPlacement& rows,
                                          const AxisPlacement& cols) {
  const auto& g = coarse.affine;
  // The corner of the first fine pixel, half a fine pixel before its sample.
  const double p = cols.first + 0.5 - cols.spacing / 2;
  const double l = rows.first + 0.5 - rows.spacing / 2;
  return {{g[0] + p * g[1] + l * g[2], g[1] * cols.spacing, g[2] * rows.spacing,
           g[3] + p * g[4] + l * g[5], g[4] * cols.spacing, g[5] * rows.spacing},
          coarse.registration};
}

}  // namespace arete
