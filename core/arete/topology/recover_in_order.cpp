// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <numeric>

#include "arete/topology/recover_part.h"

namespace arete::detail {
namespace {

// Whether the corners, from some corner on, are these.
bool runs(std::span<const int> face, const std::array<int, 4>& corners) {
  for (std::size_t first = 0; first < 4; ++first)
    if (face[first] == corners[0])
      return face[(first + 1) % 4] == corners[1] && face[(first + 2) % 4] == corners[2] &&
             face[(first + 3) % 4] == corners[3];
  return false;
}

}  // namespace

std::optional<GridPatch> recover_in_order(const FaceList& faces, int vertex_count) {
  const int count = faces.count();
  if (count == 0 || faces.corners.size() != 4 * static_cast<std::size_t>(count)) return {};
  // Face 0 lies between the vertices 0, 1, cols and cols + 1.
  if (faces[0].size() != 4) return {};
  std::array<int, 4> first{};
  std::copy_n(faces[0].begin(), 4, first.begin());
  std::sort(first.begin(), first.end());
  const int cols = first[2];
  if (first[0] != 0 || first[1] != 1 || cols < 2 || first[3] != cols + 1) return {};
  const int rows = vertex_count / cols;
  if (rows < 2 || Index{rows} * cols != vertex_count || Index{rows - 1} * (cols - 1) != count)
    return {};
  const bool mirrored = !runs(faces[0], {0, 1, cols + 1, cols});

  int f = 0;
  for (int r = 0; r + 1 < rows; ++r) {
    for (int c = 0; c + 1 < cols; ++c, ++f) {
      const int v = r * cols + c;
      if (faces.starts[static_cast<std::size_t>(f)] != 4 * f ||
          !runs(faces[f],
                {v, mirrored ? v + cols : v + 1, v + cols + 1, mirrored ? v + 1 : v + cols}))
        return {};
    }
  }
  GridPatch patch;
  patch.extent = {rows, cols};
  patch.mirrored = mirrored;
  patch.vertices.resize(static_cast<std::size_t>(vertex_count));
  std::iota(patch.vertices.begin(), patch.vertices.end(), 0);
  patch.cells.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) patch.cells.push_back({{i, -1}, Diagonal::none});
  return patch;
}

}  // namespace arete::detail
