// SPDX-License-Identifier: MIT
#include "arete/vtk/internal/gradient.h"

#include <cmath>

namespace arete::vtk {

GradientField::GradientField(const Surface& surface, const LocalPlane& plane)
    : surface_(surface),
      extent_(surface.extent()),
      scale_x_(plane.scale_x),
      scale_y_(plane.scale_y) {
  const auto& g = plane.placement.affine;
  const double area = g[1] * g[5] - g[2] * g[4];
  col_to_x_ = g[5] / area;
  row_to_x_ = -g[4] / area;
  col_to_y_ = -g[2] / area;
  row_to_y_ = g[1] / area;
}

Gradient GradientField::at(Index row, Index col) const {
  if (!surface_.valid(row, col)) return {};
  if (surface_.gradients) {
    const double dx = surface_.gradients->dz_dx(row, col);
    const double dy = surface_.gradients->dz_dy(row, col);
    if (std::isfinite(dx) && std::isfinite(dy)) return {dx / scale_x_, dy / scale_y_};
  }
  return difference(row, col);
}

Gradient GradientField::difference(Index row, Index col) const {
  const double along_col = difference_along(row, col, 0, 1);
  const double along_row = difference_along(row, col, 1, 0);
  return {col_to_x_ * along_col + row_to_x_ * along_row,
          col_to_y_ * along_col + row_to_y_ * along_row};
}

double GradientField::difference_along(Index row, Index col, Index d_row, Index d_col) const {
  const auto has = [&](Index r, Index c) {
    return r >= 0 && c >= 0 && r < extent_.rows && c < extent_.cols && surface_.valid(r, c);
  };
  const bool before = has(row - d_row, col - d_col);
  const bool after = has(row + d_row, col + d_col);
  const double here = surface_.height(row, col);
  const double low = before ? surface_.height(row - d_row, col - d_col) : here;
  const double high = after ? surface_.height(row + d_row, col + d_col) : here;
  return before && after ? (high - low) / 2 : high - low;
}

}  // namespace arete::vtk
