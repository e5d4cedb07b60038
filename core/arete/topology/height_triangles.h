// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "arete/field/grid.h"

namespace arete {

/// A height field as few triangles between some of its samples.
struct HeightTriangles {
  std::vector<Index> samples;  ///< of each vertex, row * cols + col, ascending
  /// Numbers of vertices, turning from columns to rows (clockwise on a map with row 0 in the
  /// north).
  std::vector<std::array<int, 3>> triangles;
  /// The largest vertical distance of a sample from the triangle over or under it.
  double largest_error = 0;
  Index left_out = 0;  ///< valid samples that no triangle holds
};

/// Triangulates a height field with at most so many triangles: from the corners on, the sample that
/// lies furthest from its triangle becomes a vertex of a Delaunay triangulation, until the
/// triangles are used up or every sample lies on its triangle but for rounding (Garland and
/// Heckbert 1995, "Fast polygonal approximation of terrains and height fields"). All samples are
/// looked at, on edges too, so that `largest_error` holds for every one of them.
///
/// Missing samples (not finite) are cut out: no triangle has one as a corner, inside or on an edge.
/// Every sample of a cell with four valid corners is in a triangle; others (single ones, lines one
/// sample wide) may be in none and are counted in `left_out`. Beside a hole triangles reach into
/// cells of which one corner is missing, where quads do not.
///
/// A plane takes two triangles. More triangles mostly mean less error, but not step by step: a new
/// vertex also changes the triangles around it.
///
/// Time about n log n for n samples; 16 bytes a sample and 150 a triangle. `progress` is told the
/// share done, 0..1, and may throw to stop the work.
/// \throws InvalidField for less than 2 x 2 samples, no valid triangle, most < 2, more than 2^31 -
/// 1 samples, and when the outline of the missing samples alone takes more than `most` triangles.
[[nodiscard]] HeightTriangles triangulate_heights(GridView<const double> heights, Index most,
                                                  const std::function<void(double)>& progress = {});
[[nodiscard]] HeightTriangles triangulate_heights(GridView<const float> heights, Index most,
                                                  const std::function<void(double)>& progress = {});

}  // namespace arete
