// SPDX-License-Identifier: MIT
#include "arete/topology/height_mesh.h"

#include <string>

#include "arete/topology/orient.h"
#include "arete/topology/recover.h"

namespace arete {

std::vector<Point3> height_points(const Grid<double>& heights) {
  std::vector<Point3> points;
  points.reserve(heights.samples().size());
  for (Index r = 0; r < heights.rows(); ++r)
    for (Index c = 0; c < heights.cols(); ++c)
      points.push_back({static_cast<double>(c), -static_cast<double>(r), heights(r, c)});
  return points;
}

Grid<double> heights_of(const FaceList& faces, const std::vector<Point3>& points) {
  const std::vector<GridPatch> patches =
      recover_grids(faces, static_cast<int>(points.size()), points);
  if (patches.size() != 1)
    throw InvalidField("a height field is one grid, not " + std::to_string(patches.size()) +
                       " of them");
  const GridPatch patch = oriented(patches.front(), points);
  Grid<double> heights(patch.extent);
  for (std::size_t i = 0; i < patch.vertices.size(); ++i)
    heights.samples()[i] = points[static_cast<std::size_t>(patch.vertices[i])][2];
  return heights;
}

}  // namespace arete
