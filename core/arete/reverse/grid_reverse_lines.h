// SPDX-License-Identifier: MIT
#pragma once

#include "arete/reverse/grid_reverse.h"

namespace arete {

/// Both axes of one reverse step.
template <class T>
struct GridStepAxes {
  AxisReverse<T> y;
  AxisReverse<T> x;
};

/// One step of decompose_grid, by whatever reverse the axes have: along all columns, then along all
/// rows. `coarse` and `details` must have their sizes.
template <class T>
void analyse_step(const GridStepAxes<T>& axes, GridView<const T> fine, Grid<T>& coarse,
                  GridDetails<T>& details, int threads);

/// The step back: along all rows, then along all columns, within the memory of the result.
template <class T>
[[nodiscard]] Grid<T> synthesise_step(const GridStepAxes<T>& axes, const Grid<T>& coarse,
                                      const GridDetails<T>& details, int threads);

}  // namespace arete
