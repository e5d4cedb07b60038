// SPDX-License-Identifier: MIT
#include "arete/vtk/internal/sky_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace arete::vtk {
namespace {

/// A look at another sample: where it is, and how far in the plane.
struct Look {
  Index d_row;
  Index d_col;
  double distance;
};

constexpr std::array<Index, 9> reaches{1, 2, 3, 4, 6, 9, 14, 21, 32};

std::vector<std::vector<Look>> looks(const LocalPlane& plane) {
  const auto& g = plane.placement.affine;
  std::vector<std::vector<Look>> directions;
  for (const auto& [d_row, d_col] : std::array<std::array<Index, 2>, 8>{
           {{0, 1}, {1, 1}, {1, 0}, {1, -1}, {0, -1}, {-1, -1}, {-1, 0}, {-1, 1}}}) {
    auto& direction = directions.emplace_back();
    for (const Index reach : reaches) {
      const auto r = static_cast<double>(reach * d_row);
      const auto c = static_cast<double>(reach * d_col);
      direction.push_back(
          {reach * d_row, reach * d_col, std::hypot(c * g[1] + r * g[2], c * g[4] + r * g[5])});
    }
  }
  return directions;
}

}  // namespace

Grid<float> sky_view(const Surface& surface, const LocalPlane& plane, double exaggeration) {
  const Extent extent = surface.extent();
  const auto directions = looks(plane);
  Grid<float> sky(extent, 1);
  for (Index row = 0; row < extent.rows; ++row) {
    for (Index col = 0; col < extent.cols; ++col) {
      if (!surface.valid(row, col)) continue;
      const double here = surface.height(row, col);
      double hidden = 0;
      for (const auto& direction : directions) {
        double horizon = 0;  // tangent of the elevation
        for (const Look& look : direction) {
          const Index r = row + look.d_row;
          const Index c = col + look.d_col;
          if (r < 0 || c < 0 || r >= extent.rows || c >= extent.cols) break;
          const double rise = (surface.height(r, c) - here) * exaggeration / look.distance;
          if (rise > horizon) horizon = rise;  // false for a missing sample
        }
        hidden += horizon / std::hypot(1, horizon);
      }
      sky(row, col) = static_cast<float>(1 - hidden / static_cast<double>(directions.size()));
    }
  }
  return sky;
}

}  // namespace arete::vtk
