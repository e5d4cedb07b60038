// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "arete/meshlab/cell_wedges.h"

namespace arete::meshlab {

/// One of the two triangles of a cell: its corners by number (0 north-west, 1 north-east,
/// 2 south-east, 3 south-west), and the bit of the edge that is the diagonal.
struct CellCut {
  std::array<int, 3> corners;
  std::uint8_t inner_edge;
};

/// The triangles of a cell: clockwise seen from above; mirrored: counter-clockwise.
[[nodiscard]] inline const std::array<CellCut, 2>& cell_cuts(bool mirrored, Diagonal diagonal) {
  static constexpr std::array<CellCut, 2> cuts[2][2] = {
      {{{{{0, 1, 2}, 4}, {{0, 2, 3}, 1}}}, {{{{0, 1, 3}, 2}, {{1, 2, 3}, 4}}}},
      {{{{{0, 2, 1}, 1}, {{0, 3, 2}, 4}}}, {{{{0, 3, 1}, 2}, {{1, 3, 2}, 1}}}}};
  return cuts[mirrored ? 1 : 0][diagonal == Diagonal::anti ? 1 : 0];
}

/// The middle of a triangle whose cell has its corners at these places.
[[nodiscard]] inline CellPlace middle_of(const CellCut& cut,
                                         const std::array<CellPlace, 4>& places) {
  CellPlace middle;
  for (const int k : cut.corners) {
    middle.x += places[static_cast<std::size_t>(k)].x / 3;
    middle.y += places[static_cast<std::size_t>(k)].y / 3;
  }
  return middle;
}

}  // namespace arete::meshlab
