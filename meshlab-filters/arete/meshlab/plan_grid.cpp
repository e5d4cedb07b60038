// SPDX-License-Identifier: GPL-3.0-or-later
#include "arete/meshlab/plan_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "arete/field/error.h"

namespace arete::meshlab {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

bool is_finite(const Point3& p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

// Nodes first..last of an axis from `low` to `high`, in nodes; rounding must not lose an end.
struct NodeRange {
  Index first, last;
};
NodeRange nodes_between(double low, double high, Index count) {
  constexpr double slack = 1e-9;
  return {std::max(Index{0}, static_cast<Index>(std::ceil(low - slack))),
          std::min(count - 1, static_cast<Index>(std::floor(high + slack)))};
}

}  // namespace

PlanGrid plan_grid(const std::vector<Point3>& points, double spacing) {
  const double infinity = std::numeric_limits<double>::infinity();
  double west = infinity, east = -infinity, south = infinity, north = -infinity;
  for (const Point3& p : points) {
    if (!is_finite(p)) continue;
    west = std::min(west, p[0]);
    east = std::max(east, p[0]);
    south = std::min(south, p[1]);
    north = std::max(north, p[1]);
  }
  if (west > east)
    throw InvalidField(points.empty() ? "the mesh is empty; open points or a terrain mesh first"
                                      : "no vertex has three finite coordinates");
  const double width = east - west;
  const double height = north - south;
  const double smaller = std::min(width, height);
  if (!(smaller > 0))
    throw InvalidField("all points lie on one line in plan, so there is no terrain between them");
  // The ends count although a division may have lost them by a rounding error.
  const double cols = std::floor(width / spacing * (1 + 1e-12)) + 1;
  const double rows = std::floor(height / spacing * (1 + 1e-12)) + 1;
  if (cols < 2 || rows < 2)
    throw InvalidField("a spacing of " + std::to_string(spacing) +
                       " leaves fewer than 2 x 2 vertices; choose at most " +
                       std::to_string(smaller));
  if (rows * cols > 5e8)
    throw InvalidField("a spacing of " + std::to_string(spacing) +
                       " would make more vertices than MeshLab can hold; choose a larger one");
  return {{static_cast<Index>(rows), static_cast<Index>(cols)},
          west + (width - (cols - 1) * spacing) / 2,
          south + (height - (rows - 1) * spacing) / 2,
          spacing};
}

Grid<double> heights_of_triangles(const MeshArrays& mesh, const PlanGrid& grid) {
  Grid<double> heights(grid.extent);
  std::fill(heights.samples().begin(), heights.samples().end(), nothing);
  for (const Triangle& t : mesh.triangles) {
    std::array<Point3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = mesh.positions[static_cast<std::size_t>(t[k])];
    if (!std::all_of(p.begin(), p.end(), is_finite)) continue;
    // In nodes from the north-west.
    for (Point3& q : p) {
      q[0] = (q[0] - grid.west) / grid.spacing;
      q[1] = static_cast<double>(grid.extent.rows - 1) - (q[1] - grid.south) / grid.spacing;
    }
    const double area =
        (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]);
    if (area == 0) continue;
    const auto [west, east] = std::minmax({p[0][0], p[1][0], p[2][0]});
    const auto [north, south] = std::minmax({p[0][1], p[1][1], p[2][1]});
    const NodeRange cols = nodes_between(west, east, grid.extent.cols);
    const NodeRange rows = nodes_between(north, south, grid.extent.rows);
    for (Index r = rows.first; r <= rows.last; ++r) {
      for (Index c = cols.first; c <= cols.last; ++c) {
        const double x = static_cast<double>(c) - p[0][0];
        const double y = static_cast<double>(r) - p[0][1];
        const double b = (x * (p[2][1] - p[0][1]) - y * (p[2][0] - p[0][0])) / area;
        const double d = ((p[1][0] - p[0][0]) * y - (p[1][1] - p[0][1]) * x) / area;
        if (b < -1e-9 || d < -1e-9 || b + d > 1 + 1e-9) continue;
        const double z = p[0][2] + b * (p[1][2] - p[0][2]) + d * (p[2][2] - p[0][2]);
        double& height = heights(r, c);
        if (!(height >= z)) height = z;
      }
    }
  }
  return heights;
}

}  // namespace arete::meshlab
