// SPDX-License-Identifier: MIT
#pragma once

#include "arete/vtk/surface.h"

namespace arete::vtk {

/// A surface coarse enough to draw, holding its own samples unless factor is 1.
struct ReducedSurface {
  Index factor = 1;
  /// Where its rows and columns lie among those of the original.
  AxisPlacement rows{};
  AxisPlacement cols{};
  Grid<double> heights{};
  Grid<float> dz_dx{};
  Grid<float> dz_dy{};
  Surface surface;  ///< borrows from the grids above, or from the original
};

/// Takes the mean of the valid samples of every block of factor x factor (none if fewer than half
/// of them are valid), standing at the block's centre; gradients likewise. The factor is the
/// smallest with which neither side has more than `most` samples. Up to factor - 1 samples are left
/// out along the border; a narrow strip keeps two samples across.
/// \pre check_geometry(surface) has passed.
[[nodiscard]] ReducedSurface reduce(const Surface& surface, Index most);

}  // namespace arete::vtk
