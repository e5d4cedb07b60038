// SPDX-License-Identifier: MIT
#include "arete/reverse/threshold.h"

#include <algorithm>
#include <cmath>

namespace arete {

double largest_threshold(double highest, double target, const std::function<double(double)>& rmse) {
  if (!(target >= 0) || !std::isfinite(target))
    throw InvalidField("the target RMSE must be 0 or more, in units of the input");
  if (rmse(highest) <= target) return highest;
  // Search between powers of two first, so that small thresholds are found as exactly as large
  // ones.
  double low = highest;
  for (int halvings = 0; rmse(low) > target; ++halvings) {
    if (halvings == 60) return 0;
    highest = low;
    low /= 2;
  }
  while (highest - low > 1e-3 * highest) {
    const double middle = (low + highest) / 2;
    (rmse(middle) <= target ? low : highest) = middle;
  }
  return low;
}

void drop_details(GridDecomposition<double>& parts, double threshold) {
  if (!(threshold >= 0) || !std::isfinite(threshold))
    throw InvalidField("the threshold must be 0 or more, in units of the heights");
  for (auto& level : parts.details)
    for (Grid<double>* block : level.blocks())
      for (double& detail : block->samples())
        detail =
            std::abs(detail) <= threshold ? 0 : static_cast<double>(static_cast<float>(detail));
}

DetailCount count_details(const GridDecomposition<double>& parts) {
  DetailCount count;
  for (const auto& level : parts.details)
    for (const Grid<double>* block : level.blocks()) {
      count.all += static_cast<Index>(block->samples().size());
      count.kept += std::count_if(block->samples().begin(), block->samples().end(),
                                  [](double detail) { return detail != 0; });
    }
  return count;
}

RestoreError restore_error(const Grid<double>& restored, GridView<const double> fine,
                           const ValidSamples& valid) {
  RestoreError error;
  double sum = 0;
  Index count = 0;
  for (Index r = 0; r < fine.rows(); ++r)
    for (Index c = 0; c < fine.cols(); ++c) {
      if (!valid.empty() && valid[static_cast<std::size_t>(r * fine.cols() + c)] == 0) continue;
      const double difference = std::abs(restored(r, c) - fine(r, c));
      error.largest = std::max(error.largest, difference);
      sum += difference * difference;
      ++count;
    }
  if (count > 0) error.rmse = std::sqrt(sum / static_cast<double>(count));
  return error;
}

double threshold_for_rmse(const GridDecomposition<double>& parts, GridView<const double> fine,
                          const ValidSamples& valid, const Scheme& scheme,
                          const GridReverseOptions& options, double target) {
  const auto rmse = [&](double threshold) {
    GridDecomposition<double> dropped = parts;
    drop_details(dropped, threshold);
    const Grid<double> restored =
        reconstruct_grid(dropped, fine.extent(), scheme, options, options.levels);
    return restore_error(restored, fine, valid).rmse;
  };
  double highest = 0;
  for (const auto& level : parts.details)
    for (const Grid<double>* block : level.blocks())
      for (const double detail : block->samples()) highest = std::max(highest, std::abs(detail));
  return largest_threshold(highest, target, rmse);
}

}  // namespace arete
