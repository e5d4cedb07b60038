// SPDX-License-Identifier: MIT
#include "arete/fit/predict.h"

#include <string>

#include "arete/analysis/limit_stencil.h"
#include "arete/refine/refiner.h"
#include "arete/variational/cardinal.h"

namespace arete {

Grid<double> decimated(GridView<const double> field, int factor) {
  if (factor < 1) throw InvalidField("factor = " + std::to_string(factor) + "; give at least 1");
  Grid<double> result({(field.rows() + factor - 1) / factor, (field.cols() + factor - 1) / factor});
  for (Index r = 0; r < result.rows(); ++r)
    for (Index c = 0; c < result.cols(); ++c) result(r, c) = field(r * factor, c * factor);
  return result;
}

int levels_for(const Mask& mask, int factor) {
  int levels = 0;
  int reached = 1;
  while (reached < factor && reached <= 1000000) {
    reached *= mask.arity();
    ++levels;
  }
  if (levels == 0 || reached != factor)
    throw InvalidField("factor = " + std::to_string(factor) +
                       " is no power of the scheme's arity " + std::to_string(mask.arity()) +
                       "; give e.g. " + std::to_string(mask.arity()) + " or " +
                       std::to_string(mask.arity() * mask.arity()));
  return levels;
}

Grid<double> predict(GridView<const double> coarse, const Scheme& scheme, int factor,
                     Prediction mode, int threads) {
  const Mask& mask = scheme.mask();
  RefineOptions options;
  options.levels = levels_for(mask, factor);
  options.threads = threads;
  if (mask.tau() != 0)
    throw InvalidScheme(scheme.text() +
                        " puts its samples beside the given ones (tau = " + to_string(mask.tau()) +
                        "), so that it cannot predict those between; take a scheme with tau = 0");
  if (mode == Prediction::direct) return refine(coarse, scheme, options);
  const auto limit = limit_stencil(mask);
  if (!limit) throw InvalidScheme(scheme.text() + " has no certified limit that could interpolate");
  const Grid<double> control = cardinal_control(coarse, *limit, *limit, options.boundaries);
  options.final_x = limit;
  options.final_y = limit;
  return refine(control, scheme, options);
}

}  // namespace arete
