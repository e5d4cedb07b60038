// SPDX-License-Identifier: MIT
#include "arete/refine/free_corners.h"

#include "arete/refine/refiner.h"
#include "arete/scheme/catalogue.h"

namespace arete {

Grid<double> refine_free_corners(const Grid<double>& heights, int levels) {
  if (heights.rows() < 2 || heights.cols() < 2)
    throw InvalidField("a grid without two samples along both axes has no corners");
  if (levels < 0) throw InvalidField("levels = " + std::to_string(levels) + " is negative");
  const Scheme cubic = parse_scheme("b-spline:degree=3");
  Grid<double> grid = heights;
  for (int level = 0; level < levels; ++level) {
    Grid<double> fine = refine(grid, cubic);
    const Index last_row = grid.rows() - 1;
    const Index last_col = grid.cols() - 1;
    for (const Index r : {Index{0}, last_row})
      for (const Index c : {Index{0}, last_col})
        fine(2 * r, 2 * c) =
            (6 * grid(r, c) + grid(r, c == 0 ? 1 : c - 1) + grid(r == 0 ? 1 : r - 1, c)) / 8;
    grid = std::move(fine);
  }
  return grid;
}

}  // namespace arete
