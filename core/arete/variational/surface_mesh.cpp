// SPDX-License-Identifier: MIT
#include "arete/variational/surface_mesh.h"

#include <cmath>
#include <string>

#include "arete/field/error.h"
#include "arete/variational/cotangent.h"

namespace arete {

void check_mesh(const SurfaceMesh& mesh) {
  if (mesh.fixed.size() != mesh.points.size())
    throw InvalidField("a mesh of " + std::to_string(mesh.points.size()) + " points says of " +
                       std::to_string(mesh.fixed.size()) + " whether they are fixed");
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    for (const double x : mesh.points[i])
      if (!std::isfinite(x))
        throw InvalidField("point " + std::to_string(i) + " of the surface is not finite");
  const auto n = static_cast<int>(mesh.points.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const auto exists = [n](int i) { return i >= 0 && i < n; };
    if (!exists(a) || !exists(b) || !exists(c) || a == b || b == c || c == a)
      throw InvalidField("triangle " + std::to_string(t) +
                         " of the surface does not name three different points");
  }
}

double surface_area(const SurfaceMesh& mesh) {
  double area = 0;
  for (const auto& triangle : mesh.triangles) area += length(doubled_normal(mesh, triangle)) / 2;
  return area;
}

std::vector<Point3> unit_normals(const SurfaceMesh& mesh) {
  std::vector<Point3> normals(mesh.points.size(), Point3{0, 0, 0});
  for (const auto& triangle : mesh.triangles) {
    const Point3 n = doubled_normal(mesh, triangle);
    for (const int i : triangle)
      for (std::size_t k = 0; k < 3; ++k) normals[static_cast<std::size_t>(i)][k] += n[k];
  }
  for (Point3& n : normals) {
    const double size = length(n);
    for (double& x : n) x = size > 0 ? x / size : 0;
  }
  return normals;
}

std::vector<double> mean_curvatures(const SurfaceMesh& mesh) {
  check_mesh(mesh);
  const std::vector<Point3> normals = unit_normals(mesh);
  std::vector<Point3> laplacian(mesh.points.size(), Point3{0, 0, 0});
  std::vector<double> areas(mesh.points.size(), 0);
  for (const auto& triangle : mesh.triangles) {
    const double third = length(doubled_normal(mesh, triangle)) / 6;
    for (const int i : triangle) areas[static_cast<std::size_t>(i)] += third;
  }
  for_each_cotangent(mesh, [&](int i, int j, double weight) {
    const auto a = static_cast<std::size_t>(i);
    const auto b = static_cast<std::size_t>(j);
    for (std::size_t k = 0; k < 3; ++k) {
      const double difference = weight * (mesh.points[a][k] - mesh.points[b][k]);
      laplacian[a][k] += difference;
      laplacian[b][k] -= difference;
    }
  });
  std::vector<double> curvatures(mesh.points.size(), 0);
  for (std::size_t i = 0; i < curvatures.size(); ++i)
    if (!mesh.fixed[i] && areas[i] > 0)
      curvatures[i] = dot(laplacian[i], normals[i]) / (2 * areas[i]);
  return curvatures;
}

}  // namespace arete
