// SPDX-License-Identifier: GPL-3.0-or-later
#include "arete/meshlab/cell_wedges.h"

#include <algorithm>
#include <utility>

namespace arete::meshlab {

CellWedges::CellWedges(const MeshArrays& mesh, const GridCell& cell,
                       const std::array<int, 4>& corners)
    : diagonal_(cell.diagonal) {
  for (std::size_t side = 0; side < 2; ++side) {
    const auto f = static_cast<std::size_t>(cell.faces[side]);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto corner = static_cast<std::size_t>(
          std::find(corners.begin(), corners.end(), mesh.triangles[f][k]) - corners.begin());
      wedges_[side][corner] = mesh.wedges[f][k];
    }
  }
  const auto [p, q] = diagonal_ == Diagonal::main ? std::pair(0, 2) : std::pair(1, 3);
  const auto agree = [&](int corner) {
    const auto c = static_cast<std::size_t>(corner);
    return wedges_[0][c] == wedges_[1][c];
  };
  whole_ = agree(p) && agree(q) && texture(0) == texture(1);
}

// A corner that the triangle of that side has.
int CellWedges::texture(int side) const {
  return side == 0 ? wedges_[0][0].texture : wedges_[1][2].texture;
}

WedgeUv CellWedges::operator()(int side, CellPlace place) const {
  const double x = place.x, y = place.y;
  if (whole_) {
    const auto bilinear = [&](auto member) {
      const double top = (1 - x) * wedges_[0][0].*member + x * wedges_[0][1].*member;
      const double bottom = (1 - x) * wedges_[1][3].*member + x * wedges_[1][2].*member;
      return static_cast<float>((1 - y) * top + y * bottom);
    };
    return {bilinear(&WedgeUv::u), bilinear(&WedgeUv::v), texture(0)};
  }
  // Corner weights of the triangle's linear function.
  std::array<double, 4> weights{};
  if (diagonal_ == Diagonal::main)
    weights = side == 0 ? std::array{1 - x, x - y, y, 0.0} : std::array{1 - y, 0.0, x, y - x};
  else
    weights =
        side == 0 ? std::array{1 - x - y, x, 0.0, y} : std::array{0.0, 1 - y, x + y - 1, 1 - x};
  double u = 0;
  double v = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    if (weights[k] == 0) continue;
    const WedgeUv& wedge = wedges_[static_cast<std::size_t>(side)][k];
    u += weights[k] * wedge.u;
    v += weights[k] * wedge.v;
  }
  return {static_cast<float>(u), static_cast<float>(v), texture(side)};
}

}  // namespace arete::meshlab
