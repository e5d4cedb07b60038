// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "arete/reverse/grid_reverse.h"
#include "arete/reverse/grid_reverse_lines.h"

namespace arete {

/// Whether both axes of every step are reversed by local filters and nothing is padded.
template <class T>
[[nodiscard]] bool all_local(const std::vector<GridStepAxes<T>>& steps) {
  return std::all_of(steps.begin(), steps.end(),
                     [](const auto& step) { return step.y.local() && step.x.local(); });
}

/// decompose_grid where all axes are reversed by local filters and nothing is padded: all levels in
/// one pass, row by row, down and then along, so that every row between is used while it is in
/// cache, coarse grids between levels never exist, and only results go to memory. The results are
/// those of AxisReverse along columns, then rows, level by level, to the last bit.
/// \pre there is a step, and all are local.
/// `steps`: finest first. `coarse` and `details` (finest first) must have their sizes.
template <class T>
void decompose_by_rows(const std::vector<GridStepAxes<T>>& steps, GridView<const T> fine,
                       Grid<T>& coarse, std::vector<GridDetails<T>>& details, int threads);

/// The reverse of it, for the coarsest levels: details[k] are of steps[k], the finest first.
template <class T>
void reconstruct_by_rows(const std::vector<GridStepAxes<T>>& steps, const Grid<T>& coarse,
                         std::span<const GridDetails<T>> details, Grid<T>& fine, int threads);

}  // namespace arete
