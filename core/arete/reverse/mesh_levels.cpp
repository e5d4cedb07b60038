// SPDX-License-Identifier: MIT
#include "arete/reverse/mesh_levels.h"

#include <cmath>

namespace arete {
namespace {

double length(const double* vector, Index size) {
  double sum = 0;
  for (Index c = 0; c < size; ++c) sum += vector[c] * vector[c];
  return std::sqrt(sum);
}

}  // namespace

MeshLevels decompose_mesh_levels(const MeshFaces& fine, GridView<const double> positions,
                                 const std::vector<MeshRule>& rules, ReverseMode mode, int levels) {
  if (levels < 0)
    throw InvalidField("levels = " + std::to_string(levels) + " is negative; give 0 or more");
  MeshLevels found;
  for (int level = 0; level < levels; ++level) {
    try {
      if (found.empty()) {
        found.push_back(decompose_mesh<double>(fine, positions, rules, mode));
      } else {
        const auto& last = found.back();
        found.push_back(
            decompose_mesh<double>(last.mesh.coarse, last.coarse.view(), last.rule, mode));
      }
    } catch (const InvalidField& error) {
      if (found.empty()) throw;
      throw InvalidField("only " + std::to_string(level) + " of " + std::to_string(levels) +
                         " levels can be undone; after that " + error.what());
    }
  }
  return found;
}

Grid<double> reconstruct_mesh_levels(const MeshLevels& levels) {
  Grid<double> positions;
  for (std::size_t i = levels.size(); i-- > 0;)
    positions = i + 1 == levels.size()
                    ? reconstruct_mesh(levels[i])
                    : reconstruct_mesh<double>(levels[i], std::as_const(positions).view());
  return positions;
}

void drop_details(MeshLevels& levels, double threshold) {
  if (!(threshold >= 0) || !std::isfinite(threshold))
    throw InvalidField("the threshold must be 0 or more, in units of the mesh");
  for (auto& level : levels) {
    for (Index i = 0; i < level.details.rows(); ++i) {
      double* detail = level.details.row(i);
      const bool kept = length(detail, level.details.cols()) > threshold;
      for (Index c = 0; c < level.details.cols(); ++c)
        detail[c] = kept ? static_cast<double>(static_cast<float>(detail[c])) : 0;
    }
    level.remainder = Grid<double>(level.details.extent());
  }
}

DetailCount count_details(const MeshLevels& levels) {
  DetailCount count;
  for (const auto& level : levels)
    for (Index i = 0; i < level.details.rows(); ++i) {
      ++count.all;
      if (length(level.details.row(i), level.details.cols()) != 0) ++count.kept;
    }
  return count;
}

RestoreError restore_error(const Grid<double>& restored, GridView<const double> positions) {
  RestoreError error;
  double sum = 0;
  for (Index i = 0; i < positions.rows(); ++i) {
    double squared = 0;
    for (Index c = 0; c < positions.cols(); ++c)
      squared += (restored(i, c) - positions(i, c)) * (restored(i, c) - positions(i, c));
    error.largest = std::max(error.largest, std::sqrt(squared));
    sum += squared;
  }
  if (positions.rows() > 0) error.rmse = std::sqrt(sum / static_cast<double>(positions.rows()));
  return error;
}

double threshold_for_rmse(const MeshLevels& levels, GridView<const double> positions,
                          double target) {
  double highest = 0;
  for (const auto& level : levels)
    for (Index i = 0; i < level.details.rows(); ++i)
      highest = std::max(highest, length(level.details.row(i), level.details.cols()));
  return largest_threshold(highest, target, [&](double threshold) {
    MeshLevels dropped = levels;
    drop_details(dropped, threshold);
    return restore_error(reconstruct_mesh_levels(dropped), positions).rmse;
  });
}

}  // namespace arete
