// SPDX-License-Identifier: MIT
#include "cli/refine_surface.h"

#include "arete/analysis/limit_stencil.h"
#include "arete/vtk/write_image.h"
#include "arete/vtk/write_polydata.h"
#include "arete/vtk/write_structured_grid.h"
#include "cli/find_band.h"
#include "cli/memory_size.h"
#include "cli/raster_surface.h"
#include "cli/refine_grid.h"

namespace arete::cli {
namespace {

// What a writer holds for a sample beside the heights themselves: points, normals, slope, cells.
double bytes_per_sample(const std::string& form) {
  if (form == ".vti") return 16;
  return form == ".vts" ? 80 : 140;
}

struct GradientGrids {
  Grid<float> dz_dx;
  Grid<float> dz_dy;
};

// Derivatives of the limit surface by world coordinates, when there are limit tangents.
template <class T>
std::optional<GradientGrids> limit_gradients(GridView<const T> samples, const Scheme& x,
                                             const Scheme& y, RefineOptions options,
                                             const Georeference& fine, ProgressBar& progress) {
  const auto limit_x = limit_stencil(x.mask());
  const auto limit_y = limit_stencil(y.mask());
  const auto slope_x = derivative_stencil(x.mask());
  const auto slope_y = derivative_stencil(y.mask());
  if (!limit_x || !limit_y || !slope_x || !slope_y) return std::nullopt;
  options.final_result = FinalResult::attribute;
  options.final_x = slope_x;
  options.final_y = limit_y;
  const Grid<T> along_row = refine_with_progress(Refiner<T>(x, y, samples.extent(), options),
                                                 samples, progress, 0.3, 0.5);
  options.final_x = limit_x;
  options.final_y = slope_y;
  const Grid<T> along_column = refine_with_progress(Refiner<T>(x, y, samples.extent(), options),
                                                    samples, progress, 0.5, 0.7);

  // dz/dcol = z_x g1 + z_y g4, dz/drow = z_x g2 + z_y g5, solved for z_x and z_y.
  const auto& g = fine.affine;
  const double determinant = g[1] * g[5] - g[2] * g[4];
  GradientGrids gradients{Grid<float>(along_row.extent()), Grid<float>(along_row.extent())};
  for (std::size_t i = 0; i < along_row.samples().size(); ++i) {
    const double dcol = along_row.samples()[i];
    const double drow = along_column.samples()[i];
    gradients.dz_dx.samples()[i] = static_cast<float>((dcol * g[5] - drow * g[4]) / determinant);
    gradients.dz_dy.samples()[i] = static_cast<float>((drow * g[1] - dcol * g[2]) / determinant);
  }
  return gradients;
}

template <class T>
gdal::RasterReport refine_as(const gdal::Raster& input, int band,
                             const std::filesystem::path& output, const std::string& form,
                             const Scheme& x, const Scheme& y, const RefineOptions& options,
                             double max_memory, ProgressBar& progress) {
  const Refiner<T> refiner(x, y, input.extent(), options);
  const Extent size = refiner.output();
  const double samples = static_cast<double>(size.rows) * static_cast<double>(size.cols);
  check_memory("a " + form + " of " + std::to_string(size.cols) + " x " +
                   std::to_string(size.rows) + " samples",
               samples * (static_cast<double>(sizeof(T)) + bytes_per_sample(form)), max_memory);
  const Grid<T> coarse = gdal::read_band<T>(input, find_band(input, band));
  const Grid<T> heights =
      refine_with_progress(refiner, coarse.view(), progress, 0, form == ".vti" ? 0.7 : 0.3);
  check_any_valid(input, heights);

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
      gradients = limit_gradients(coarse.view(), x, y, options, surface.georeference, progress);
    if (gradients)
      surface.gradients = vtk::Gradients{gradients->dz_dx.view(), gradients->dz_dy.view()};
    surface.notes.push_back({"normals", gradients ? "limit tangents" : "central differences"});
    if (form == ".vts")
      vtk::write_structured_grid(surface, output);
    else
      vtk::write_polydata(surface, output);
  }
  progress.show(1);
  return {input.extent(), size, 1, to_double(refiner.x().misplacement()),
          to_double(refiner.y().misplacement())};
}

}  // namespace

gdal::RasterReport refine_to_surface(const gdal::Raster& input, int band,
                                     const std::filesystem::path& output, const std::string& form,
                                     const Scheme& x, const Scheme& y, const RefineOptions& options,
                                     gdal::SampleType type, double max_memory,
                                     ProgressBar& progress) {
  return type == gdal::SampleType::float32
             ? refine_as<float>(input, band, output, form, x, y, options, max_memory, progress)
             : refine_as<double>(input, band, output, form, x, y, options, max_memory, progress);
}

}  // namespace arete::cli
