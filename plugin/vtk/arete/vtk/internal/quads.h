// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "arete/vtk/surface.h"

class vtkPolyData;

namespace arete::vtk {

/// Whether the quad with the least corner (row, col) lies in the raster with all corners valid.
[[nodiscard]] inline bool whole_quad(const Surface& surface, Index row, Index col) {
  const Extent extent = surface.extent();
  return row >= 0 && col >= 0 && row + 1 < extent.rows && col + 1 < extent.cols &&
         surface.valid(row, col) && surface.valid(row, col + 1) && surface.valid(row + 1, col) &&
         surface.valid(row + 1, col + 1);
}

/// Gives `out` the quads whose four corners are all valid, counter-clockwise seen from above. Ids
/// are 32 bits wide where they fit. Points are numbered in the raster's order, only those that a
/// quad uses.
/// \returns the sample (row * cols + col) of every point; `out` has cells but no points yet.
[[nodiscard]] std::vector<Index> set_quads(const Surface& surface, vtkPolyData& out);

}  // namespace arete::vtk
