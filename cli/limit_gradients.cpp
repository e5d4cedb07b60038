// SPDX-License-Identifier: MIT
#include "cli/limit_gradients.h"

#include "arete/analysis/limit_stencil.h"
#include "cli/refine_grid.h"

namespace arete::cli {

template <class T>
std::optional<GradientGrids> limit_gradients(GridView<const T> samples, const Scheme& x,
                                             const Scheme& y, RefineOptions options,
                                             const Georeference& fine, ProgressBar& progress,
                                             double from, double to) {
  const auto limit_x = limit_stencil(x.mask());
  const auto limit_y = limit_stencil(y.mask());
  const auto slope_x = derivative_stencil(x.mask());
  const auto slope_y = derivative_stencil(y.mask());
  if (!limit_x || !limit_y || !slope_x || !slope_y) return std::nullopt;
  options.final_result = FinalResult::attribute;
  options.final_x = slope_x;
  options.final_y = limit_y;
  const double middle = (from + to) / 2;
  const Grid<T> along_row = refine_with_progress(Refiner<T>(x, y, samples.extent(), options),
                                                 samples, progress, from, middle);
  options.final_x = limit_x;
  options.final_y = slope_y;
  const Grid<T> along_column = refine_with_progress(Refiner<T>(x, y, samples.extent(), options),
                                                    samples, progress, middle, to);

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

template std::optional<GradientGrids> limit_gradients(GridView<const float>, const Scheme&,
                                                      const Scheme&, RefineOptions,
                                                      const Georeference&, ProgressBar&, double,
                                                      double);
template std::optional<GradientGrids> limit_gradients(GridView<const double>, const Scheme&,
                                                      const Scheme&, RefineOptions,
                                                      const Georeference&, ProgressBar&, double,
                                                      double);

}  // namespace arete::cli
