// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "arete/meshlab/mesh_arrays.h"
#include "arete/topology/grid_patch.h"

namespace arete::meshlab {

/// A place in a cell: x along its row, y along its column, 0..1 inside, (0, 0) the north-west.
struct CellPlace {
  double x = 0;
  double y = 0;
};

/// Which of a cell's two triangles a place lies in.
[[nodiscard]] inline int cell_side(Diagonal diagonal, CellPlace place) {
  const bool upper = diagonal == Diagonal::anti ? place.x + place.y < 1 : place.x > place.y;
  return upper ? 0 : 1;
}

/// Texture coordinates inside a cell, as functions of the place: bilinear where its two triangles
/// agree along their diagonal, otherwise (a seam runs there) linear in each.
class CellWedges {
 public:
  /// `corners`: the cell's vertices, north-west, north-east, south-east, south-west.
  CellWedges(const MeshArrays& mesh, const GridCell& cell, const std::array<int, 4>& corners);

  /// At a place in or beside the cell, seen from triangle `side` (0 or 1).
  [[nodiscard]] WedgeUv operator()(int side, CellPlace place) const;
  [[nodiscard]] int texture(int side) const;

 private:
  Diagonal diagonal_;
  bool whole_ = false;
  // By side, by corner.
  std::array<std::array<WedgeUv, 4>, 2> wedges_{};
};

}  // namespace arete::meshlab
