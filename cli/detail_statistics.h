// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "arete/gdal/raster.h"
#include "arete/metrics/spectrum.h"

namespace arete::cli {

/// How rough a raster was and has become, by profiles of its middle (at most 1024 x 1024 samples).
struct DetailStatistics {
  std::optional<SpectralSlope> before;  ///< of the input, all its octaves
  std::optional<SpectralSlope> after;   ///< of the result, the octaves that refinement made
};

/// `factor`: samples of the result along an axis for one of the input; first data band of both.
[[nodiscard]] DetailStatistics detail_statistics(const gdal::Raster& input,
                                                 const gdal::Raster& result, double factor);

/// The same of samples in memory.
[[nodiscard]] DetailStatistics detail_statistics(GridView<const float> input,
                                                 GridView<const float> result, double factor);
[[nodiscard]] DetailStatistics detail_statistics(GridView<const double> input,
                                                 GridView<const double> result, double factor);

}  // namespace arete::cli
