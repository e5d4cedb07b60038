// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "arete/field/georeference.h"
#include "arete/refine/refiner.h"
#include "cli/progress.h"

namespace arete::cli {

struct GradientGrids {
  Grid<float> dz_dx;
  Grid<float> dz_dy;
};

/// Derivatives of the limit surface by world coordinates at the samples of the last level, T float
/// or double; nothing
/// unless both schemes are certified to have limit tangents. `fine` is where those samples lie.
template <class T>
[[nodiscard]] std::optional<GradientGrids> limit_gradients(
    GridView<const T> samples, const Scheme& x, const Scheme& y, RefineOptions options,
    const Georeference& fine, ProgressBar& progress, double from, double to);

}  // namespace arete::cli
