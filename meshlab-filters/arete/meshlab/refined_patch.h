// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "arete/meshlab/axis_samples.h"
#include "arete/meshlab/mesh_arrays.h"
#include "arete/meshlab/patch_place.h"
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

  [[nodiscard]] PatchPlace place(Index r, Index c) const {
    return {rows_.samples()[static_cast<std::size_t>(r)],
            cols_.samples()[static_cast<std::size_t>(c)]};
  }

  /// Appends the new triangles with diagonals, sides and polygon bits, the old triangle each lies
  /// in, and the wedges if the old mesh has any.
  void append_faces(const MeshArrays& old_mesh, RefinedMesh& result) const;

 private:
  void number_vertices(int& next_vertex);

  const GridPatch* patch_;
  AxisSamples rows_;
  AxisSamples cols_;
  std::vector<int> vertices_;
  std::vector<int> dropped_;
};

}  // namespace arete::meshlab
