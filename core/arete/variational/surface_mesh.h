// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

namespace arete {

using Point3 = std::array<double, 3>;

/// A triangulated surface some of whose points are held fast.
struct SurfaceMesh {
  std::vector<Point3> points;
  /// Three point numbers each, all with the same orientation.
  std::vector<std::array<int, 3>> triangles;
  /// One a point: true for those that must not move (the boundary).
  std::vector<bool> fixed;
};

/// \throws InvalidField unless there is one `fixed` a point, coordinates are finite, and triangles
/// name three different points that exist.
void check_mesh(const SurfaceMesh& mesh);

/// The sum of the triangles' areas.
[[nodiscard]] double surface_area(const SurfaceMesh& mesh);

/// Mean curvature at every point that is free and belongs to a triangle, 0 elsewhere:
/// H_i = (L x)_i . n_i / (2 A_i) with the cotangent Laplacian L, the unit normal n_i (mean of the
/// triangles' normals by area) and A_i a third of the area around (Meyer, Desbrun, Schroeder, Barr
/// 2003, with barycentric cells). In 1/length; its sign says which way the surface bends.
[[nodiscard]] std::vector<double> mean_curvatures(const SurfaceMesh& mesh);

}  // namespace arete
