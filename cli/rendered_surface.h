// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "arete/gdal/raster.h"
#include "arete/vtk/surface.h"
#include "cli/limit_gradients.h"

namespace arete::cli {

/// A raster's band in memory as a surface to draw, at its own samples or refined.
class RenderedSurface {
 public:
  /// As read, averaged down so that no side has more than `largest_side` samples.
  RenderedSurface(const gdal::Raster& raster, const gdal::BandInfo& band, Index largest_side);
  /// Refined, with the limit surface's own tangents where both it and they are certified to exist.
  /// \throws Failure if it does not fit into half of the machine's memory.
  RenderedSurface(const gdal::Raster& raster, const gdal::BandInfo& band, const Scheme& scheme,
                  int levels, ProgressBar& progress);

  [[nodiscard]] vtk::Surface surface() const;
  /// How many input samples a side were averaged into one.
  [[nodiscard]] Index factor() const { return factor_; }

 private:
  const gdal::Raster& raster_;
  Grid<float> heights_;
  Georeference place_;
  Index factor_ = 1;
  std::optional<GradientGrids> gradients_;
};

}  // namespace arete::cli
