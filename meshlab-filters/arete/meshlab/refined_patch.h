// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "arete/meshlab/axis_samples.h"
#include "arete/meshlab/mesh_arrays.h"
#include "arete/topology/grid_patch.h"

namespace arete::meshlab {

/// A grid of a mesh before and after refinement: numbers of the new vertices and their places among
/// the old ones. It holds no coordinates.
class RefinedPatch {
 public:
  /// `patch` must outlive this. New vertices are numbered from next_vertex on, row by row; it is
  /// moved behind the last one.
  RefinedPatch(const GridPatch& patch, AxisSamples rows, AxisSamples cols, int& next_vertex);

  [[nodiscard]] const GridPatch& old() const { return *patch_; }
  [[nodiscard]] const AxisSamples& rows() const { return rows_; }
  [[nodiscard]] const AxisSamples& cols() const { return cols_; }
  [[nodiscard]] Extent extent() const {
    return {static_cast<Index>(rows_.samples().size()), static_cast<Index>(cols_.samples().size())};
  }
  [[nodiscard]] int vertex(Index r, Index c) const {
    return vertices_[static_cast<std::size_t>(r * extent().cols + c)];
  }
  /// Old vertices in whose place there is no new one.
  [[nodiscard]] const std::vector<int>& dropped() const { return dropped_; }

  /// The bilinear blend of a number of the old vertices at the place of the new vertex (r, c).
  /// Exactly the old number at an old place.
  [[nodiscard]] double blend(const auto& old_value, Index r, Index c) const {
    const AxisSample& y = rows_.samples()[static_cast<std::size_t>(r)];
    const AxisSample& x = cols_.samples()[static_cast<std::size_t>(c)];
    const Index next_row = next(y.cell, patch_->extent.rows);
    const Index next_col = next(x.cell, patch_->extent.cols);
    const double top = mix(old_value(patch_->vertex(y.cell, x.cell)),
                           old_value(patch_->vertex(y.cell, next_col)), x.t);
    if (y.t == 0) return top;
    return mix(top,
               mix(old_value(patch_->vertex(next_row, x.cell)),
                   old_value(patch_->vertex(next_row, next_col)), x.t),
               y.t);
  }
  /// The old vertex nearest to the new vertex (r, c).
  [[nodiscard]] int nearest_old_vertex(Index r, Index c) const;

  /// Appends the new triangles with diagonals, sides and polygon bits, the old triangle each lies
  /// in, and the wedges if the old mesh has any.
  void append_faces(const MeshArrays& old_mesh, RefinedMesh& result) const;

 private:
  static Index next(Index i, Index count) { return i + 1 < count ? i + 1 : 0; }
  // Equal numbers stay what they are, so that straight rows of vertices stay straight.
  static double mix(double a, double b, double t) {
    return t == 0 || a == b ? a : (1 - t) * a + t * b;
  }
  void number_vertices(int& next_vertex);

  const GridPatch* patch_;
  AxisSamples rows_;
  AxisSamples cols_;
  std::vector<int> vertices_;
  std::vector<int> dropped_;
};

}  // namespace arete::meshlab
