// SPDX-License-Identifier: MIT
#include "cli/rendered_surface.h"

#include <utility>

#include "arete/gdal/reduced_band.h"
#include "arete/gdal/refine_raster.h"
#include "cli/memory_size.h"
#include "cli/raster_surface.h"
#include "cli/refine_grid.h"

namespace arete::cli {

RenderedSurface::RenderedSurface(const gdal::Raster& raster, const gdal::BandInfo& band,
                                 Index largest_side)
    : raster_(raster) {
  gdal::ReducedBand reduced = gdal::read_reduced_band(raster, band, largest_side);
  heights_ = std::move(reduced.samples);
  place_ = reduced.georeference;
  factor_ = reduced.factor;
}

RenderedSurface::RenderedSurface(const gdal::Raster& raster, const gdal::BandInfo& band,
                                 const Scheme& scheme, int levels, ProgressBar& progress)
    : raster_(raster) {
  RefineOptions options;
  options.levels = levels;
  const Refiner<float> refiner(scheme, scheme, raster.extent(), options);
  const Extent size = refiner.output();
  check_memory("a picture of " + std::to_string(size.cols) + " x " + std::to_string(size.rows) +
                   " refined samples (use fewer levels)",
               20.0 * static_cast<double>(size.rows) * static_cast<double>(size.cols),
               default_memory());
  const Grid<float> coarse = gdal::read_band<float>(raster, band);
  heights_ = refine_with_progress(refiner, coarse.view(), progress, 0, 0.3);
  check_any_valid(raster, heights_);
  place_ = refined(raster.place(), refiner);
  gradients_ = limit_gradients(coarse.view(), scheme, scheme, options, place_, progress, 0.3, 0.9);
}

vtk::Surface RenderedSurface::surface() const {
  vtk::Surface surface = raster_surface<float>(raster_, place_, heights_.view());
  if (gradients_)
    surface.gradients = vtk::Gradients{gradients_->dz_dx.view(), gradients_->dz_dy.view()};
  return surface;
}

}  // namespace arete::cli
