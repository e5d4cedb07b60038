// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "arete/field/grid.h"
#include "arete/meshlab/mesh_arrays.h"

namespace arete::meshlab {

/// Square cells in plan; row 0 is the northern one (largest y).
struct PlanGrid {
  Extent extent;
  double west = 0;
  double south = 0;
  double spacing = 1;

  [[nodiscard]] double x(Index col) const { return west + static_cast<double>(col) * spacing; }
  [[nodiscard]] double y(Index row) const {
    return south + static_cast<double>(extent.rows - 1 - row) * spacing;
  }
};

/// As many nodes of that spacing as fit into the box of the finite points, in its middle.
/// \throws InvalidField if there is no finite point, or fewer than 2 x 2 nodes fit (the message
/// says which spacing would do), or more than MeshLab can hold.
[[nodiscard]] PlanGrid plan_grid(const std::vector<Point3>& points, double spacing);

/// Heights of the mesh's own triangles at the nodes, the highest where they overlap, NaN beside
/// them. Triangles with a corner that is not finite, and vertical ones, are passed over.
[[nodiscard]] Grid<double> heights_of_triangles(const MeshArrays& mesh, const PlanGrid& grid);

}  // namespace arete::meshlab
