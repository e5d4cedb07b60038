// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "arete/gdal/band_source.h"
#include "arete/refine/refiner.h"
#include "cli/error.h"
#include "cli/progress.h"

namespace arete::cli {

/// Refines in memory, by bands, so that progress shows (from `from` to `to`) and Ctrl-C is heard.
template <class T>
[[nodiscard]] Grid<T> refine_with_progress(const Refiner<T>& refiner, GridView<const T> samples,
                                           ProgressBar& progress, double from, double to) {
  Grid<T> result(refiner.output());
  const GridSource<T> source(samples);
  constexpr Index band = 512;
  for (Index first = 0; first < result.rows(); first += band) {
    const Index rows = std::min(band, result.rows() - first);
    refiner.refine_rows(source, first, GridView<T>(result.row(first), {rows, result.cols()}));
    progress.show(from + (to - from) * static_cast<double>(first + rows) /
                             static_cast<double>(result.rows()));
  }
  return result;
}

/// \throws Failure if no sample of what a raster became is valid.
template <class T>
void check_any_valid(const gdal::Raster& input, const Grid<T>& heights) {
  if (std::none_of(heights.samples().begin(), heights.samples().end(),
                   [](T value) { return std::isfinite(value); }))
    throw Failure(input.path() +
                  " has no valid result: no four neighbouring samples are all "
                  "valid; check its nodata value with gdalinfo");
}

}  // namespace arete::cli
