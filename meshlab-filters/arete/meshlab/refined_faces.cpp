// SPDX-License-Identifier: GPL-3.0-or-later
// The triangles of a refined patch, and texture coordinates of their corners.
#include <algorithm>
#include <optional>
#include <utility>

#include "arete/meshlab/refined_patch.h"

namespace arete::meshlab {
namespace {

std::size_t at(Index index) { return static_cast<std::size_t>(index); }

// A place in an old cell: x along its row, y along its column, 0..1 inside.
struct Place {
  double x;
  double y;
};

// The old cell's two triangles as functions of the place.
class CellWedges {
 public:
  CellWedges(const MeshArrays& mesh, const GridCell& cell, const std::array<int, 4>& corners)
      : diagonal_(cell.diagonal) {
    for (std::size_t side = 0; side < 2; ++side) {
      const auto f = at(cell.faces[side]);
      for (std::size_t k = 0; k < 3; ++k) {
        const auto corner = static_cast<std::size_t>(
            std::find(corners.begin(), corners.end(), mesh.triangles[f][k]) - corners.begin());
        wedges_[side][corner] = mesh.wedges[f][k];
      }
    }
    const auto [p, q] = diagonal_ == Diagonal::main ? std::pair(0, 2) : std::pair(1, 3);
    whole_ = wedges_[0][at(p)] == wedges_[1][at(p)] && wedges_[0][at(q)] == wedges_[1][at(q)] &&
             wedges_[0][0].texture == wedges_[1][2].texture;
  }

  // `side`: the old triangle in which the new one lies.
  [[nodiscard]] WedgeUv operator()(int side, Place at_place) const {
    const auto [x, y] = at_place;
    const auto& w = wedges_[at(side)];
    if (whole_) {
      const auto bilinear = [&](auto member) {
        const double top = (1 - x) * wedges_[0][0].*member + x * wedges_[0][1].*member;
        const double bottom = (1 - x) * wedges_[1][3].*member + x * wedges_[1][2].*member;
        return static_cast<float>((1 - y) * top + y * bottom);
      };
      return {bilinear(&WedgeUv::u), bilinear(&WedgeUv::v), wedges_[0][0].texture};
    }
    // Corner weights of the triangle's linear function.
    std::array<double, 4> weights{};
    if (diagonal_ == Diagonal::main)
      weights = side == 0 ? std::array{1 - x, x - y, y, 0.0} : std::array{1 - y, 0.0, x, y - x};
    else
      weights =
          side == 0 ? std::array{1 - x - y, x, 0.0, y} : std::array{0.0, 1 - y, x + y - 1, 1 - x};
    WedgeUv result;
    double u = 0;
    double v = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      if (weights[k] == 0) continue;
      u += weights[k] * w[k].u;
      v += weights[k] * w[k].v;
    }
    result.u = static_cast<float>(u);
    result.v = static_cast<float>(v);
    result.texture = w[side == 0 ? 0 : 2].texture;
    return result;
  }

 private:
  Diagonal diagonal_;
  bool whole_ = false;
  // By side, by corner: north-west, north-east, south-east, south-west.
  std::array<std::array<WedgeUv, 4>, 2> wedges_{};
};

// Corners of the two triangles of a new cell, and the edge of each that is the diagonal, for faces
// that run north-west, north-east, south-east, south-west; then for mirrored ones.
struct Cut {
  std::array<int, 3> corners;
  std::uint8_t inner_edge;
};
constexpr Cut cuts[2][2][2] = {
    {{{{0, 1, 2}, 4}, {{0, 2, 3}, 1}}, {{{0, 1, 3}, 2}, {{1, 2, 3}, 4}}},
    {{{{0, 2, 1}, 1}, {{0, 3, 2}, 4}}, {{{0, 3, 1}, 2}, {{1, 3, 2}, 1}}}};

}  // namespace

void RefinedPatch::append_faces(const MeshArrays& old_mesh, RefinedMesh& result) const {
  const Extent fine = extent();
  const Extent coarse = patch_->extent;
  for (Index r = 0; r < static_cast<Index>(rows_.cells().size()); ++r) {
    const AxisCell& y = rows_.cells()[at(r)];
    for (Index c = 0; c < static_cast<Index>(cols_.cells().size()); ++c) {
      const AxisCell& x = cols_.cells()[at(c)];
      const GridCell& cell = patch_->cell(y.owner, x.owner);
      const bool anti = cell.diagonal == Diagonal::anti;
      const std::array<int, 4> vertices{vertex(r, c), vertex(r, next(c, fine.cols)),
                                        vertex(next(r, fine.rows), next(c, fine.cols)),
                                        vertex(next(r, fine.rows), c)};
      const std::array<Place, 4> places{
          {{x.begin, y.begin}, {x.end, y.begin}, {x.end, y.end}, {x.begin, y.end}}};
      std::optional<CellWedges> wedges;
      if (!old_mesh.wedges.empty()) {
        const Index down = next(y.owner, coarse.rows);
        const Index right = next(x.owner, coarse.cols);
        wedges.emplace(old_mesh, cell,
                       std::array{patch_->vertex(y.owner, x.owner), patch_->vertex(y.owner, right),
                                  patch_->vertex(down, right), patch_->vertex(down, x.owner)});
      }
      for (const Cut& cut : cuts[patch_->mirrored ? 1 : 0][anti ? 1 : 0]) {
        Triangle triangle{};
        Place middle{0, 0};
        for (std::size_t k = 0; k < 3; ++k) {
          const auto corner = at(cut.corners[k]);
          triangle[k] = vertices[corner];
          middle.x += places[corner].x / 3;
          middle.y += places[corner].y / 3;
        }
        const bool upper = anti ? middle.x + middle.y < 1 : middle.x > middle.y;
        const int side = upper ? 0 : 1;
        result.arrays.triangles.push_back(triangle);
        result.arrays.inner_edges.push_back(cut.inner_edge);
        result.source_triangles.push_back(cell.faces[at(side)]);
        if (!wedges) continue;
        auto& corners = result.arrays.wedges.emplace_back();
        for (std::size_t k = 0; k < 3; ++k)
          corners[k] = (*wedges)(side, places[at(cut.corners[k])]);
      }
    }
  }
}

}  // namespace arete::meshlab
