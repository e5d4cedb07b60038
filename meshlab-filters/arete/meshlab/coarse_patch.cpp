// SPDX-License-Identifier: GPL-3.0-or-later
#include "arete/meshlab/coarse_patch.h"

#include <cmath>

#include "arete/field/at.h"
#include "arete/meshlab/cell_cut.h"
#include "arete/meshlab/cell_wedges.h"

namespace arete::meshlab {
namespace {

AxisSample sample_at(double position, Index count, bool wraps) {
  const double whole = std::floor(position);
  auto cell = static_cast<Index>(whole);
  if (wraps) return {0, ((cell % count) + count) % count, position - whole};
  cell = std::clamp(cell, Index{0}, count - 2);
  return {0, cell, position - static_cast<double>(cell)};
}

// A place in the coordinates of a cell in which the place `known`, given in both, is known.
CellPlace seen_from(const PatchPlace& cell, CellPlace known, CellPlace place) {
  return {place.x - std::round(known.x - cell.col.t), place.y - std::round(known.y - cell.row.t)};
}

}  // namespace

CoarsePatch::CoarsePatch(const GridPatch& fine, const AxisPlacement& rows,
                         const AxisPlacement& cols, int& next_vertex)
    : fine_(&fine), rows_(rows), cols_(cols), first_vertex_(next_vertex) {
  next_vertex += static_cast<int>(rows.count * cols.count);
}

PatchPlace CoarsePatch::place_at(double row, double col) const {
  return {sample_at(row, fine_->extent.rows, fine_->wraps_rows),
          sample_at(col, fine_->extent.cols, fine_->wraps_cols)};
}

void CoarsePatch::append_faces(const MeshArrays& fine_mesh, CreatedMesh& result) const {
  const bool has_wedges = !fine_mesh.wedges.empty();
  const auto cell_at = [&](const PatchPlace& place) -> const GridCell& {
    return fine_->cell(place.row.cell, place.col.cell);
  };
  const auto inside = [](const PatchPlace& place) { return CellPlace{place.col.t, place.row.t}; };
  const auto wedges_at = [&](const PatchPlace& place) {
    return CellWedges(fine_mesh, cell_at(place),
                      cell_corners(*fine_, place.row.cell, place.col.cell));
  };

  const Index cell_rows = rows_.count - (fine_->wraps_rows ? 0 : 1);
  const Index cell_cols = cols_.count - (fine_->wraps_cols ? 0 : 1);
  for (Index r = 0; r < cell_rows; ++r) {
    const double north = position(rows_, r);
    const double south = position(rows_, r + 1);
    const Index down = following(r, rows_.count);
    for (Index c = 0; c < cell_cols; ++c) {
      const double west = position(cols_, c);
      const double east = position(cols_, c + 1);
      const Index right = following(c, cols_.count);
      const std::array<int, 4> vertices{vertex(r, c), vertex(r, right), vertex(down, right),
                                        vertex(down, c)};
      const std::array<CellPlace, 4> places{
          {{west, north}, {east, north}, {east, south}, {west, south}}};
      const Diagonal diagonal = cell_at(place_at((north + south) / 2, (west + east) / 2)).diagonal;
      for (const CellCut& cut : cell_cuts(fine_->mirrored, diagonal)) {
        const CellPlace middle = middle_of(cut, places);
        const PatchPlace centre = place_at(middle.y, middle.x);
        const GridCell& source = cell_at(centre);
        const int side = cell_side(source.diagonal, inside(centre));
        Triangle triangle{};
        for (std::size_t k = 0; k < 3; ++k) triangle[k] = vertices[at(cut.corners[k])];
        result.arrays.triangles.push_back(triangle);
        result.arrays.inner_edges.push_back(cut.inner_edge);
        result.source_triangles.push_back(source.faces[at(side)]);
        if (!has_wedges) continue;
        const CellWedges here = wedges_at(centre);
        auto& corners = result.arrays.wedges.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
          const auto [x, y] = places[at(cut.corners[k])];
          // A little towards the middle, to be in a cell of this triangle's side.
          const CellPlace inner{x + (middle.x - x) / 64, y + (middle.y - y) / 64};
          const PatchPlace near = place_at(inner.y, inner.x);
          const CellWedges there = wedges_at(near);
          const int near_side = cell_side(cell_at(near).diagonal, inside(near));
          if (there.texture(near_side) == here.texture(side))
            corners[k] = there(near_side, seen_from(near, inner, {x, y}));
          else
            corners[k] = here(side, seen_from(centre, middle, {x, y}));
        }
      }
    }
  }
}

}  // namespace arete::meshlab
