// SPDX-License-Identifier: MIT
#pragma once

#include "arete/gdal/raster.h"

namespace arete::gdal {

/// A band in memory at a size fit for a picture.
struct ReducedBand {
  Grid<float> samples;
  Georeference georeference;
  Index factor = 1;  ///< how many input samples a side were averaged into one
};

/// Reads a band, averaging the valid samples of blocks so that no side is longer than
/// `largest_side`; a block without valid samples is a NaN. One pass, memory of the result.
/// Without georeference, sample (row, col) is put at x = col, y = -row. \throws RasterError
[[nodiscard]] ReducedBand read_reduced_band(const Raster& raster, const BandInfo& band,
                                            Index largest_side);

}  // namespace arete::gdal
