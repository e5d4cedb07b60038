// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "arete/field/georeference.h"
#include "arete/meshlab/patch_place.h"

namespace arete::meshlab {

/// A grid of a mesh, and a coarser one that shall stand beside it: numbers of the new vertices and
/// their places among the old ones. It holds no coordinates.
class CoarsePatch {
 public:
  /// Coarse sample (r, c) lies at rows.first + r rows.spacing, cols.first + c cols.spacing, up to
  /// half a spacing beyond the rim. `fine` must outlive this. New vertices are numbered from
  /// next_vertex on, row by row; it is moved behind the last one.
  CoarsePatch(const GridPatch& fine, const AxisPlacement& rows, const AxisPlacement& cols,
              int& next_vertex);

  [[nodiscard]] const GridPatch& fine() const { return *fine_; }
  [[nodiscard]] Extent extent() const { return {rows_.count, cols_.count}; }
  [[nodiscard]] int vertex(Index r, Index c) const {
    return first_vertex_ + static_cast<int>(r * cols_.count + c);
  }
  [[nodiscard]] PatchPlace place(Index r, Index c) const {
    return place_at(position(rows_, r), position(cols_, c));
  }

  /// Appends the coarse triangles with diagonals, sides and polygon bits, the old triangle under
  /// the middle of each, and the wedges if the fine mesh has any: those of the old triangles at the
  /// corners, or, where they are of another texture, those of the triangle under the middle.
  void append_faces(const MeshArrays& fine_mesh, CreatedMesh& result) const;

 private:
  static double position(const AxisPlacement& axis, Index i) {
    return axis.first + static_cast<double>(i) * axis.spacing;
  }
  [[nodiscard]] PatchPlace place_at(double row, double col) const;

  const GridPatch* fine_;
  AxisPlacement rows_;
  AxisPlacement cols_;
  int first_vertex_;
};

}  // namespace arete::meshlab
