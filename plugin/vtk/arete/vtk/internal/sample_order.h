// SPDX-License-Identifier: MIT
#pragma once

#include "arete/vtk/surface.h"

namespace arete::vtk {

struct Sample {
  Index row = 0;
  Index col = 0;
};

/// In which order samples become the points of a structured VTK grid. VTK's (i, j, k) is
/// right-handed with k up, a north-up raster's (col, row) is not: its rows are taken from the last.
struct SampleOrder {
  Extent extent{};
  bool flip_rows = false;
  bool flip_cols = false;

  [[nodiscard]] Sample at(Index i, Index j) const {
    return {flip_rows ? extent.rows - 1 - j : j, flip_cols ? extent.cols - 1 - i : i};
  }
  /// Point id = i + j * cols, as in VTK.
  [[nodiscard]] Sample at(Index point) const {
    return at(point % extent.cols, point / extent.cols);
  }
};

/// Rows are flipped where that is needed for normals to look up.
[[nodiscard]] SampleOrder right_handed_order(const Surface& surface);

}  // namespace arete::vtk
