// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "arete/reverse/missing_samples.h"

namespace arete {

/// How many details are held, and how many are not zero.
struct DetailCount {
  Index all = 0;
  Index kept = 0;
};

/// Sets details with |d| <= threshold to zero and rounds the others to float32, the type in which
/// lossy details are kept. \throws InvalidField for a negative threshold or one that is not finite.
void drop_details(GridDecomposition<double>& parts, double threshold);

[[nodiscard]] DetailCount count_details(const GridDecomposition<double>& parts);

/// How far a restored grid is from the original, over its valid samples.
struct RestoreError {
  double rmse = 0;
  double largest = 0;
};

[[nodiscard]] RestoreError restore_error(const Grid<double>& restored, GridView<const double> fine,
                                         const ValidSamples& valid);

/// The largest threshold up to `highest`, found by bisection to 1/1000 of itself, with
/// rmse(threshold) <= target; 0 if there is none. \throws InvalidField for a negative target.
[[nodiscard]] double largest_threshold(double highest, double target,
                                       const std::function<double(double)>& rmse);

/// The largest threshold found by bisection (to 1/1000 of itself) whose restored grid has an RMSE
/// of at most `target`; 0 if even that drops too much. Costs some 20 reconstructions. \throws
/// InvalidField for a negative target.
[[nodiscard]] double threshold_for_rmse(const GridDecomposition<double>& parts,
                                        GridView<const double> fine, const ValidSamples& valid,
                                        const Scheme& scheme, const GridReverseOptions& options,
                                        double target);

}  // namespace arete
