// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "arete/field/grid.h"
#include "arete/scheme/scheme.h"

namespace arete {

/// How a scheme predicts samples between given ones.
enum class Prediction {
  direct,        ///< refined as they are
  interpolating  ///< control points first whose limit passes through them (cardinal mode), then
                 ///< the limit
};

/// Every factor-th sample of a field along both axes, from the first on: rows (n - 1)/factor + 1.
[[nodiscard]] Grid<double> decimated(GridView<const double> field, int factor);

/// How many levels of a scheme make `factor` samples of one. \throws InvalidField unless factor is
/// a power of the arity, at least once.
[[nodiscard]] int levels_for(const Mask& mask, int factor);

/// The samples factor times as dense, (n - 1) factor + 1 along each axis, boundary `extrapolate`.
/// Missing samples are allowed for `direct`.
///
/// \throws InvalidScheme if the scheme's samples lie elsewhere (tau is not 0), or it is asked to
/// interpolate and has no limit that can (see cardinal.h); InvalidField as levels_for(), and for
/// missing samples with `interpolating`.
[[nodiscard]] Grid<double> predict(GridView<const double> coarse, const Scheme& scheme, int factor,
                                   Prediction mode, int threads = 1);

}  // namespace arete
