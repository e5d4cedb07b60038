// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "arete/cgal/scattered_grid.h"
#include "arete/meshlab/mesh_arrays.h"
#include "arete/meshlab/progress.h"

namespace arete::meshlab {

struct FromPointsOptions {
  double spacing = 1;
  /// None: the heights of the mesh's own triangles; only what they leave open is found by the
  /// Delaunay triangles of the vertices.
  std::optional<cgal::GridMethod> method = cgal::GridMethod::natural_neighbour;
  /// Beyond the hull of the points. nodata: the terrain has gaps there.
  cgal::OutsideHull outside = cgal::OutsideHull::nearest;
  double drop_outliers = 0;  ///< see cgal::GridRequest; 0: all points count
};

/// A regular grid of quads, in plan, through the vertices of a mesh: points, or any terrain mesh.
/// Every number of the vertices (colour, quality) comes along, linear on Delaunay triangles.
///
/// Points with a coordinate that is not finite are passed over, which the log tells.
/// \throws InvalidField as plan_grid() and cgal::grid_points(), if there are no faces although
/// theirs are asked for, and if no cell has four heights; Cancelled.
[[nodiscard]] CreatedMesh terrain_from_points(const MeshArrays& mesh,
                                              const FromPointsOptions& options, Report& report);

}  // namespace arete::meshlab
