// SPDX-License-Identifier: MIT
#include "arete/openmesh/internal/plain_mesh.h"

#include <cmath>
#include <string>

namespace arete::openmesh::detail {

Grid<double> positions_of(const MeshData& mesh) {
  Grid<double> positions({static_cast<Index>(mesh.points.size()), 3});
  for (Index v = 0; v < positions.rows(); ++v) {
    const Point3& point = mesh.points[static_cast<std::size_t>(v)];
    for (std::size_t c = 0; c < 3; ++c) {
      if (!std::isfinite(point[c]))
        throw InvalidField("vertex " + std::to_string(v) +
                           " has a coordinate that is no finite number; remove it");
      positions(v, static_cast<Index>(c)) = point[c];
    }
  }
  return positions;
}

void set_points(MeshData& mesh, const Grid<double>& positions) {
  mesh.points.clear();
  for (Index v = 0; v < positions.rows(); ++v)
    mesh.points.push_back({positions(v, 0), positions(v, 1), positions(v, 2)});
}

}  // namespace arete::openmesh::detail
