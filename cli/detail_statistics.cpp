// SPDX-License-Identifier: MIT
#include "cli/detail_statistics.h"

#include <algorithm>

#include "arete/gdal/band_source.h"

namespace arete::cli {
namespace {

// The middle of samples that come by `read_row(row, out)`.
template <class T, class ReadRow>
Grid<double> middle(Extent all, const ReadRow& read_row) {
  constexpr Index most = 1024;
  Grid<double> part({std::min(all.rows, most), std::min(all.cols, most)});
  std::vector<T> line(static_cast<std::size_t>(all.cols));
  for (Index r = 0; r < part.rows(); ++r) {
    read_row((all.rows - part.rows()) / 2 + r, line.data());
    std::copy_n(line.begin() + (all.cols - part.cols()) / 2, part.cols(), part.row(r));
  }
  return part;
}

Grid<double> middle(const gdal::Raster& raster) {
  const gdal::BandSource<double> source(raster, raster.bands().front());
  return middle<double>(raster.extent(), [&](Index row, double* out) { source.read(row, out); });
}

template <class T>
Grid<double> middle(GridView<const T> samples) {
  return middle<T>(samples.extent(),
                   [&](Index row, T* out) { std::copy_n(samples.row(row), samples.cols(), out); });
}

DetailStatistics statistics_of(const Grid<double>& input, const Grid<double>& result,
                               double factor) {
  return {spectral_slope(input.view()), refined_slope(result.view(), factor)};
}

}  // namespace

DetailStatistics detail_statistics(const gdal::Raster& input, const gdal::Raster& result,
                                   double factor) {
  return statistics_of(middle(input), middle(result), factor);
}

DetailStatistics detail_statistics(GridView<const float> input, GridView<const float> result,
                                   double factor) {
  return statistics_of(middle(input), middle(result), factor);
}

DetailStatistics detail_statistics(GridView<const double> input, GridView<const double> result,
                                   double factor) {
  return statistics_of(middle(input), middle(result), factor);
}

}  // namespace arete::cli
