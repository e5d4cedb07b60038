// SPDX-License-Identifier: MIT
#include "arete/gdal/reduced_band.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "arete/gdal/band_source.h"

namespace arete::gdal {

ReducedBand read_reduced_band(const Raster& raster, const BandInfo& band, Index largest_side) {
  const Extent extent = raster.extent();
  const Index factor =
      std::max<Index>(1, (std::max(extent.rows, extent.cols) + largest_side - 1) / largest_side);
  // Blocks cut by the far edges are left out: their mean would not lie at their centre.
  const Extent reduced{std::max<Index>(1, extent.rows / factor),
                       std::max<Index>(1, extent.cols / factor)};
  ReducedBand result{Grid<float>(reduced), {}, factor};
  const BandSource<double> source(raster, band);
  std::vector<double> line(static_cast<std::size_t>(extent.cols));
  std::vector<double> sums(static_cast<std::size_t>(reduced.cols));
  std::vector<Index> counts(sums.size());
  for (Index row = 0; row < reduced.rows; ++row) {
    std::fill(sums.begin(), sums.end(), 0.0);
    std::fill(counts.begin(), counts.end(), Index{0});
    for (Index r = row * factor; r < std::min((row + 1) * factor, extent.rows); ++r) {
      source.read(r, line.data());
      for (Index c = 0; c < std::min(reduced.cols * factor, extent.cols); ++c) {
        const double value = line[static_cast<std::size_t>(c)];
        if (!std::isfinite(value)) continue;
        sums[static_cast<std::size_t>(c / factor)] += value;
        ++counts[static_cast<std::size_t>(c / factor)];
      }
    }
    for (Index c = 0; c < reduced.cols; ++c) {
      const auto i = static_cast<std::size_t>(c);
      result.samples(row, c) = counts[i] == 0
                                   ? std::numeric_limits<float>::quiet_NaN()
                                   : static_cast<float>(sums[i] / static_cast<double>(counts[i]));
    }
  }
  const double first = (static_cast<double>(factor) - 1) / 2;
  result.georeference = refined(raster.place(), {reduced.rows, first, static_cast<double>(factor)},
                                {reduced.cols, first, static_cast<double>(factor)});
  return result;
}

}  // namespace arete::gdal
