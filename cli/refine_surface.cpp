// SPDX-License-Identifier: MIT
#include "cli/refine_surface.h"

#include <algorithm>
#include <cmath>

#include "arete/variational/cardinal.h"
#include "arete/vtk/write_image.h"
#include "arete/vtk/write_model.h"
#include "arete/vtk/write_polydata.h"
#include "arete/vtk/write_structured_grid.h"
#include "cli/drape.h"
#include "cli/find_band.h"
#include "cli/limit_gradients.h"
#include "cli/memory_size.h"
#include "cli/raster_surface.h"
#include "cli/refine_grid.h"

namespace arete::cli {
namespace {

// What a writer holds for a sample beside the heights themselves: points, normals, slope, cells.
double bytes_per_sample(const std::string& form) {
  if (form == ".vti") return 16;
  if (form == ".glb") return 250;
  return form == ".vts" ? 80 : 140;
}

void write_glb(const gdal::Raster& input, const vtk::Surface& surface, const ModelLook& look,
               const std::filesystem::path& output) {
  vtk::ModelOptions model;
  model.appearance = look.appearance;
  if (!look.texture.empty())
    model.appearance.texture =
        drape(look.texture, input, surface.georeference, surface.extent(), false);
  model.most_samples = std::max(surface.extent().rows, surface.extent().cols);
  vtk::write_glb(surface, model, output);
}

template <class T>
RefinedSurface refine_as(const gdal::Raster& input, int band, const std::filesystem::path& output,
                         const std::string& form, const Scheme& x, const Scheme& y,
                         const RefineOptions& options, double max_memory, const ModelLook& look,
                         const std::optional<gdal::LimitWeights>& interpolate,
                         ProgressBar& progress) {
  const Refiner<T> refiner(x, y, input.extent(), options);
  const Extent size = refiner.output();
  const double samples = static_cast<double>(size.rows) * static_cast<double>(size.cols);
  check_memory("a " + form + " of " + std::to_string(size.cols) + " x " +
                   std::to_string(size.rows) + " samples",
               samples * (static_cast<double>(sizeof(T)) + bytes_per_sample(form)), max_memory);
  Grid<T> coarse = gdal::read_band<T>(input, find_band(input, band));
  RefinedSurface done{{input.extent(), size, 1, to_double(refiner.x().misplacement()),
                       to_double(refiner.y().misplacement())},
                      {}};
  const Grid<T> given = options.detail ? coarse : Grid<T>();
  if (interpolate)
    coarse = cardinal_control<T>(std::as_const(coarse).view(), interpolate->x, interpolate->y,
                                 options.boundaries);
  const Grid<T> heights = refine_with_progress(refiner, std::as_const(coarse).view(), progress, 0,
                                               form == ".vti" ? 0.7 : 0.3);
  check_any_valid(input, heights);
  if (options.detail)
    done.detail =
        detail_statistics(given.view(), heights.view(), std::pow(x.mask().arity(), options.levels));

  vtk::Surface surface = raster_surface<T>(input, refined(input.place(), refiner), heights.view());
  surface.notes = {{"arete_scheme", x.text()},
                   {"arete_scheme_y", y.text()},
                   {"arete_levels", std::to_string(options.levels)}};
  if (form == ".vti") {
    vtk::write_image(surface, output);
  } else {
    std::optional<GradientGrids> gradients;
    // Tangents of the limit know nothing of random detail.
    if (!options.final_x && !options.detail)
      gradients = limit_gradients(std::as_const(coarse).view(), x, y, options, surface.georeference,
                                  progress, 0.3, 0.7);
    if (gradients)
      surface.gradients = vtk::Gradients{gradients->dz_dx.view(), gradients->dz_dy.view()};
    surface.notes.push_back({"normals", gradients ? "limit tangents" : "central differences"});
    if (form == ".glb")
      write_glb(input, surface, look, output);
    else if (form == ".vts")
      vtk::write_structured_grid(surface, output);
    else
      vtk::write_polydata(surface, output);
  }
  progress.show(1);
  return done;
}

}  // namespace

RefinedSurface refine_to_surface(const gdal::Raster& input, int band,
                                 const std::filesystem::path& output, const std::string& form,
                                 const Scheme& x, const Scheme& y, const RefineOptions& options,
                                 gdal::SampleType type, double max_memory, const ModelLook& look,
                                 const std::optional<gdal::LimitWeights>& interpolate,
                                 ProgressBar& progress) {
  return type == gdal::SampleType::float32
             ? refine_as<float>(input, band, output, form, x, y, options, max_memory, look,
                                interpolate, progress)
             : refine_as<double>(input, band, output, form, x, y, options, max_memory, look,
                                 interpolate, progress);
}

}  // namespace arete::cli
