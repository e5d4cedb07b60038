// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "arete/fit/parameter_space.h"
#include "arete/fit/predict.h"

namespace arete {

enum class FitCriterion {
  rmse,      ///< root of the mean squared error of held-out samples
  roughness  ///< the profile spectrum of the new samples' octaves, by logarithms
};

/// Terrain whose samples are known, and those from which they shall be predicted:
/// factor (n - 1) + 1 samples of truth where coarse has n.
struct FitData {
  Grid<double> truth;
  Grid<double> coarse;
  int factor = 2;
  bool coarse_is_given = false;  ///< not of truth, so that all of truth is held out
  Index margin = 4;              ///< coarse samples along the rim that do not count
  int folds = 5;                 ///< parts of the cross-validation
  int threads = 1;
};

/// Every factor-th sample of a field given, the others held out; what lies beyond the last given
/// row and column is cut off. \throws InvalidField for a factor below 2.
[[nodiscard]] FitData fit_data(const Grid<double>& truth, int factor);
/// The same with the given samples from elsewhere; both are cut to their common part.
[[nodiscard]] FitData fit_data(const Grid<double>& truth, const Grid<double>& coarse, int factor);

/// \throws InvalidField if the extents do not fit or fewer than 100 samples are held out.
void check(const FitData& data);

/// Which samples of truth count (1): held out, finite, inside the margin.
[[nodiscard]] std::vector<char> held_out(const FitData& data);

/// Which part of the cross-validation a sample belongs to: square blocks of terrain, an eighth of
/// the longer side, dealt out so that neighbours belong to different parts.
[[nodiscard]] int fold_of(const FitData& data, Index row, Index col);

struct SchemeFit {
  Scheme scheme;
  Prediction mode = Prediction::direct;
  double rmse = 0;  ///< over all held-out samples
  /// Each part predicted by a scheme fitted to the others; NaN for `roughness`.
  double cross_validated_rmse = 0;
  int steps = 0;
  bool converged = false;
};

/// Told the share done; may throw.
using FitProgress = std::function<void(double)>;

/// The member of `space` that best predicts held-out samples. Where the prediction is linear in
/// the parameters (one level of an interpolatory scheme along one axis) one step solves it;
/// products of both axes, further levels and cardinal mode take a few (see gauss_newton.h). \throws
/// InvalidScheme, InvalidField as predict() at the start.
[[nodiscard]] SchemeFit fit_scheme(const FitData& data, const ParameterSpace& space,
                                   Prediction mode, FitCriterion criterion,
                                   const FitProgress& progress = {});

}  // namespace arete
