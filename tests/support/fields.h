// SPDX-License-Identifier: MIT
#pragma once

#include <random>

#include "arete/field/grid.h"

namespace arete::test {

/// Heights whose products with dyadic weights are exact for many levels: integers in -512..511 over
/// 8.
template <class T = double>
Grid<T> dyadic_heights(Extent extent, unsigned seed = 7) {
  std::mt19937 random(seed);
  Grid<T> grid(extent);
  for (T& value : grid.samples()) value = (static_cast<T>(random() % 1024) - T(512)) / T(8);
  return grid;
}

/// Heights with full mantissas.
template <class T = double>
Grid<T> random_heights(Extent extent, unsigned seed = 11) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<T> number(-100, 900);
  Grid<T> grid(extent);
  for (T& value : grid.samples()) value = number(random);
  return grid;
}

/// constant + row_slope r + col_slope c.
template <class T = double>
Grid<T> plane(Extent extent, T constant, T row_slope, T col_slope) {
  Grid<T> grid(extent);
  for (Index r = 0; r < extent.rows; ++r)
    for (Index c = 0; c < extent.cols; ++c)
      grid(r, c) = constant + row_slope * static_cast<T>(r) + col_slope * static_cast<T>(c);
  return grid;
}

}  // namespace arete::test
