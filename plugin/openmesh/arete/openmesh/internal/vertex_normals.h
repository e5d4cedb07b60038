// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "arete/openmesh/internal/components.h"
#include "arete/openmesh/internal/limit_frame.h"
#include "arete/topology/face_list.h"

namespace arete::openmesh::detail {

/// The stencils of both axes.
struct Frames {
  LimitStencils along_rows;
  LimitStencils along_cols;
};

template <class Mesh>
void set_unit_normal(Mesh& mesh, int vertex, const std::array<double, 3>& n) {
  using Normal = typename Mesh::Normal;
  Normal normal = mesh.normal(typename Mesh::VertexHandle(vertex));
  for (std::size_t k = 0; k < 3; ++k)
    Components<Normal>::set(normal, k, static_cast<typename Components<Normal>::Scalar>(n[k]));
  mesh.set_normal(typename Mesh::VertexHandle(vertex), normal);
}

/// The cross product of central differences of the new points, one-sided at a rim; (0, 0, 0) where
/// they are parallel.
template <class Mesh>
std::array<double, 3> difference_normal(const Mesh& mesh, int west, int east, int north, int south,
                                        bool mirrored) {
  using C = Components<typename Mesh::Point>;
  const auto difference = [&](int a, int b) {
    std::array<double, 3> d{};
    for (std::size_t k = 0; k < 3; ++k)
      d[k] = static_cast<double>(C::get(mesh.point(typename Mesh::VertexHandle(b)), k)) -
             static_cast<double>(C::get(mesh.point(typename Mesh::VertexHandle(a)), k));
    return d;
  };
  const auto u = difference(west, east);
  const auto v = difference(north, south);
  std::array<double, 3> n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                          u[0] * v[1] - u[1] * v[0]};
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  for (double& x : n) x = length > 0 ? (mirrored ? -x : x) / length : 0;
  return n;
}

template <class Mesh>
void set_difference_normals(Mesh& mesh, const RefinedPatch& patch) {
  const Index rows = patch.rows.fine();
  const Index cols = patch.cols.fine();
  std::array<std::vector<int>, 3> lines;
  for (auto& line : lines) line.resize(static_cast<std::size_t>(cols));
  const auto beside = [](Index i, Index step, Index count, bool wraps) {
    return wraps ? (i + step + count) % count : std::clamp(i + step, Index{0}, count - 1);
  };
  for (Index r = 0; r < rows; ++r) {
    for (Index step : {-1, 0, 1})
      patch.row_vertices(beside(r, step, rows, patch.rows.wraps),
                         lines[static_cast<std::size_t>(step + 1)]);
    for (Index c = 0; c < cols; ++c) {
      const auto at = [&](std::size_t line, Index step) {
        return lines[line][static_cast<std::size_t>(beside(c, step, cols, patch.cols.wraps))];
      };
      set_unit_normal(
          mesh, at(1, 0),
          difference_normal(mesh, at(1, -1), at(1, 1), at(0, 0), at(2, 0), patch.coarse.mirrored));
    }
  }
}

/// Normals of every vertex of every patch. `frames`: take those of the limit surface.
template <class Mesh>
void set_vertex_normals(Mesh& mesh, const Rebuild& rebuild, const RebuildOptions& options,
                        const std::optional<Frames>& frames,
                        const std::vector<Point3>& old_positions, int threads) {
  for (const RefinedPatch& patch : rebuild.patches) {
    set_difference_normals(mesh, patch);
    if (!frames) continue;
    std::array<Grid<double>, 3> planes;
    for (std::size_t k = 0; k < 3; ++k) {
      planes[k] = Grid<double>(patch.coarse.extent);
      for (std::size_t i = 0; i < patch.coarse.vertices.size(); ++i)
        planes[k].samples()[i] =
            old_positions[static_cast<std::size_t>(patch.coarse.vertices[i])][k];
    }
    // Where the limit has no normal, or cannot be had, that of the differences stays.
    (void)limit_normals(patch, options, frames->along_rows, frames->along_cols,
                        {&planes[0], &planes[1], &planes[2]}, threads,
                        [&](Index r, std::span<const std::array<double, 3>> normals) {
                          std::vector<int> vertices(normals.size());
                          patch.row_vertices(r, vertices);
                          for (std::size_t c = 0; c < normals.size(); ++c)
                            if (normals[c] != std::array<double, 3>{})
                              set_unit_normal(mesh, vertices[c], normals[c]);
                        });
  }
}

}  // namespace arete::openmesh::detail
