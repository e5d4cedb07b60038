// SPDX-License-Identifier: GPL-3.0-or-later
// The triangles of a refined patch, and texture coordinates of their corners.
#include <optional>

#include "arete/meshlab/cell_cut.h"
#include "arete/field/at.h"
#include "arete/meshlab/cell_wedges.h"
#include "arete/meshlab/refined_patch.h"

namespace arete::meshlab {
namespace {

}  // namespace

void RefinedPatch::append_faces(const MeshArrays& old_mesh, RefinedMesh& result) const {
  const Extent fine = extent();
  for (Index r = 0; r < static_cast<Index>(rows_.cells().size()); ++r) {
    const AxisCell& y = rows_.cells()[at(r)];
    for (Index c = 0; c < static_cast<Index>(cols_.cells().size()); ++c) {
      const AxisCell& x = cols_.cells()[at(c)];
      const GridCell& cell = patch_->cell(y.owner, x.owner);
      const std::array<int, 4> vertices{vertex(r, c), vertex(r, following(c, fine.cols)),
                                        vertex(following(r, fine.rows), following(c, fine.cols)),
                                        vertex(following(r, fine.rows), c)};
      const std::array<CellPlace, 4> places{
          {{x.begin, y.begin}, {x.end, y.begin}, {x.end, y.end}, {x.begin, y.end}}};
      std::optional<CellWedges> wedges;
      if (!old_mesh.wedges.empty())
        wedges.emplace(old_mesh, cell, cell_corners(*patch_, y.owner, x.owner));
      for (const CellCut& cut : cell_cuts(patch_->mirrored, cell.diagonal)) {
        Triangle triangle{};
        for (std::size_t k = 0; k < 3; ++k) triangle[k] = vertices[at(cut.corners[k])];
        const int side = cell_side(cell.diagonal, middle_of(cut, places));
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
