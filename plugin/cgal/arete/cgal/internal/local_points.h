// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "arete/cgal/scattered_grid.h"

namespace arete::cgal::detail {

struct LocalPoint {
  double x, y, z;
};

/// Finite points, one for each place, about a local origin: world = origin + local * 2^exponent.
struct LocalPoints {
  std::vector<LocalPoint> points;  ///< by x, then y
  WorldPoint origin;
  int exponent = 0;
  PlaneBox box;  ///< of the finite points, in world coordinates
  Index not_finite = 0;
  Index merged = 0;

  [[nodiscard]] double scaled(double length) const;
};

/// \throws InvalidField for arrays of different lengths or no finite point.
[[nodiscard]] LocalPoints local_points(const ScatteredPoints& points);

/// The bounding box of the finite points. \throws InvalidField as local_points().
[[nodiscard]] PlaneBox bounding_box(const ScatteredPoints& points);

}  // namespace arete::cgal::detail
