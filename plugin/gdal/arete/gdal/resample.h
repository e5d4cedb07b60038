// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "arete/field/grid.h"
#include "arete/gdal/error.h"

namespace arete::gdal {

/// What gdalwarp makes of a field on the lattice on which sample (0, 0) stays where it is and
/// `factor` samples stand where one stood: factor (n - 1) + 1 along each axis. NaN is missing.
/// `kernel` is gdalwarp's -r: bilinear, cubic, cubicspline, lanczos, ...
/// \throws RasterError for an unknown kernel, or more than 2^31 - 1 samples a side.
[[nodiscard]] Grid<double> resampled(GridView<const double> field, const std::string& kernel,
                                     int factor);

}  // namespace arete::gdal
