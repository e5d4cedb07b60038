// SPDX-License-Identifier: MIT
#include "arete/topology/grid_faces.h"

#include <array>
#include <limits>
#include <string>
#include <utility>

namespace arete {

FaceList grid_faces(Extent extent, bool mirrored, bool wraps_rows, bool wraps_cols) {
  const Index rows = extent.rows - (wraps_rows ? 0 : 1);
  const Index cols = extent.cols - (wraps_cols ? 0 : 1);
  if (4.0 * static_cast<double>(extent.rows) * static_cast<double>(extent.cols) >
      std::numeric_limits<int>::max())
    throw InvalidField("a mesh of " + std::to_string(extent.rows) + " x " +
                       std::to_string(extent.cols) +
                       " vertices exceeds 32-bit numbering; use fewer levels or a raster format");
  FaceList faces;
  if (rows < 1 || cols < 1) return faces;
  faces.starts.reserve(static_cast<std::size_t>(rows * cols + 1));
  faces.corners.reserve(static_cast<std::size_t>(4 * rows * cols));
  for (Index r = 0; r < rows; ++r) {
    const Index below = (r + 1) % extent.rows;
    for (Index c = 0; c < cols; ++c) {
      const Index right = (c + 1) % extent.cols;
      std::array<int, 4> face{
          static_cast<int>(r * extent.cols + c), static_cast<int>(r * extent.cols + right),
          static_cast<int>(below * extent.cols + right), static_cast<int>(below * extent.cols + c)};
      if (mirrored) std::swap(face[1], face[3]);
      faces.add(face);
    }
  }
  return faces;
}

}  // namespace arete
