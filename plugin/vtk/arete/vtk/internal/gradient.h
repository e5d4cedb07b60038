// SPDX-License-Identifier: MIT
#pragma once

#include "arete/vtk/internal/local_plane.h"
#include "arete/vtk/surface.h"

namespace arete::vtk {

/// Slope of the surface in the local plane: height units per plane unit.
struct Gradient {
  double dx = 0;
  double dy = 0;
};

/// Gradients of a surface sample by sample: the given ones where they are, differences elsewhere.
/// Borrows both arguments.
class GradientField {
 public:
  GradientField(const Surface& surface, const LocalPlane& plane);

  /// Zero at a missing sample, and along a direction without a neighbour.
  [[nodiscard]] Gradient at(Index row, Index col) const;

 private:
  [[nodiscard]] Gradient difference(Index row, Index col) const;
  [[nodiscard]] double difference_along(Index row, Index col, Index d_row, Index d_col) const;

  const Surface& surface_;
  Extent extent_;
  double scale_x_;
  double scale_y_;
  // Inverse transpose of the map's linear part: from differences along rows and columns to the
  // plane's axes.
  double col_to_x_, row_to_x_, col_to_y_, row_to_y_;
};

}  // namespace arete::vtk
