// SPDX-License-Identifier: MIT
#include "cli/detail_statistics.h"

#include <algorithm>

#include "arete/gdal/band_source.h"

namespace arete::cli {
namespace {

Grid<double> middle(const gdal::Raster& raster) {
  constexpr Index most = 1024;
  const Extent all = raster.extent();
  Grid<double> part({std::min(all.rows, most), std::min(all.cols, most)});
  const gdal::BandSource<double> source(raster, raster.bands().front());
  std::vector<double> line(static_cast<std::size_t>(all.cols));
  for (Index r = 0; r < part.rows(); ++r) {
    source.read((all.rows - part.rows()) / 2 + r, line.data());
    std::copy_n(line.begin() + (all.cols - part.cols()) / 2, part.cols(), part.row(r));
  }
  return part;
}

}  // namespace

DetailStatistics detail_statistics(const gdal::Raster& input, const gdal::Raster& result,
                                   double factor) {
  return {spectral_slope(middle(input).view()),
          spectral_slope(profile_spectrum(middle(result).view()), 0.5 / factor, 0.5)};
}

}  // namespace arete::cli
