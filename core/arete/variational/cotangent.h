// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "arete/variational/surface_mesh.h"

namespace arete {

/// What relax.cpp and surface_mesh.cpp share: triangles and their cotangents.

[[nodiscard]] inline double dot(const Point3& a, const Point3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
[[nodiscard]] inline double length(const Point3& a) { return std::sqrt(dot(a, a)); }
[[nodiscard]] inline Point3 difference(const Point3& a, const Point3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
[[nodiscard]] inline Point3 cross(const Point3& a, const Point3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Normal of a triangle, twice its area long.
[[nodiscard]] inline Point3 doubled_normal(const SurfaceMesh& mesh,
                                           const std::array<int, 3>& triangle) {
  const Point3& a = mesh.points[static_cast<std::size_t>(triangle[0])];
  return cross(difference(mesh.points[static_cast<std::size_t>(triangle[1])], a),
               difference(mesh.points[static_cast<std::size_t>(triangle[2])], a));
}

/// Unit normals by area, (0,0,0) where there is none.
[[nodiscard]] std::vector<Point3> unit_normals(const SurfaceMesh& mesh);

/// visit(i, j, cot/2 of the angle opposite to the edge i j) for the three edges of every triangle;
/// E_D = 1/2 sum weight |x_i - x_j|^2. Cotangents are cut off at +-1e8 (needles); a triangle
/// without area has none.
template <class Visit>
void for_each_cotangent(const SurfaceMesh& mesh, Visit&& visit) {
  for (const auto& triangle : mesh.triangles) {
    const double twice_area = length(doubled_normal(mesh, triangle));
    for (std::size_t k = 0; k < 3; ++k) {
      const int i = triangle[(k + 1) % 3];
      const int j = triangle[(k + 2) % 3];
      const Point3& apex = mesh.points[static_cast<std::size_t>(triangle[k])];
      const Point3 a = difference(mesh.points[static_cast<std::size_t>(i)], apex);
      const Point3 b = difference(mesh.points[static_cast<std::size_t>(j)], apex);
      const double cosine = dot(a, b);
      const double limit = 1e8 * twice_area;
      const double clamped = cosine > limit ? limit : cosine < -limit ? -limit : cosine;
      visit(i, j, twice_area > 0 ? clamped / twice_area / 2 : 0.0);
    }
  }
}

}  // namespace arete
