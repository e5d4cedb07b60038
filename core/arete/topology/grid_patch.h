// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "arete/field/grid.h"

namespace arete {

/// How a cell is cut into triangles.
enum class Diagonal : std::uint8_t {
  none,  ///< a quad
  main,  ///< from (r, c) to (r+1, c+1)
  anti   ///< from (r, c+1) to (r+1, c)
};

/// The face, or the two triangles, between the vertices (r, c) and (r+1, c+1). The first triangle
/// holds the edge from (r, c) to (r, c+1), the second that from (r+1, c) to (r+1, c+1).
struct GridCell {
  std::array<int, 2> faces{-1, -1};
  Diagonal diagonal = Diagonal::none;
};

/// A part of a mesh that is a regular grid: which vertex and which face sits where.
///
/// An axis that wraps has no end: its last vertex is followed by its first, so a cylinder wraps
/// along one axis and a torus along both. Along an axis that wraps there are as many cells as
/// vertices, otherwise one less.
struct GridPatch {
  Extent extent;                ///< in vertices, at least 2 x 2 (3 along an axis that wraps)
  bool wraps_rows = false;      ///< row extent.rows - 1 is followed by row 0
  bool wraps_cols = false;      ///< column extent.cols - 1 is followed by column 0
  std::vector<int> vertices;    ///< row-major
  std::vector<GridCell> cells;  ///< row-major
  /// Faces run (r, c), (r, c+1), (r+1, c+1), (r+1, c); mirrored: the other way round.
  bool mirrored = false;

  [[nodiscard]] Index cell_rows() const { return extent.rows - (wraps_rows ? 0 : 1); }
  [[nodiscard]] Index cell_cols() const { return extent.cols - (wraps_cols ? 0 : 1); }
  [[nodiscard]] int vertex(Index r, Index c) const {
    return vertices[static_cast<std::size_t>(r * extent.cols + c)];
  }
  [[nodiscard]] const GridCell& cell(Index r, Index c) const {
    return cells[static_cast<std::size_t>(r * cell_cols() + c)];
  }
  [[nodiscard]] bool is_triangulated() const {
    return !cells.empty() && cells.front().diagonal != Diagonal::none;
  }
};

}  // namespace arete
