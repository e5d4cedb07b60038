// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "arete/field/boundary.h"
#include "arete/openmesh/internal/refined_axis.h"
#include "arete/scheme/scheme.h"
#include "arete/scheme/stencil.h"
#include "arete/topology/grid_patch.h"

namespace arete::openmesh::detail {

/// A grid patch before and after refinement, and how its new elements are numbered: everything row
/// by row. Row r of edges holds the edges along row r of vertices, then those from row r to row
/// r + 1, then the diagonals between the two.
struct RefinedPatch {
  GridPatch coarse;
  RefinedAxis rows;
  RefinedAxis cols;
  int first_vertex = 0;  ///< of the vertices that were not there before
  int first_edge = 0;
  int first_face = 0;
  bool keeps_vertices = false;  ///< old vertices are among the new ones and keep their numbers

  [[nodiscard]] Extent fine() const { return {rows.fine(), cols.fine()}; }
  [[nodiscard]] bool triangles() const { return coarse.is_triangulated(); }
  [[nodiscard]] Index new_vertices() const;
  [[nodiscard]] Index edges() const;
  [[nodiscard]] Index faces() const {
    return rows.fine_cells() * cols.fine_cells() * (triangles() ? 2 : 1);
  }

  /// The vertex numbers of fine row r.
  void row_vertices(Index r, std::span<int> out) const;

  [[nodiscard]] int edge_along_row(Index r, Index cell) const {
    return first_edge + static_cast<int>(r * edges_per_row() + cell);
  }
  [[nodiscard]] int edge_to_next_row(Index cell_row, Index c) const {
    return edge_along_row(cell_row, cols.fine_cells() + c);
  }
  [[nodiscard]] int diagonal(Index cell_row, Index cell_col) const {
    return edge_along_row(cell_row, cols.fine_cells() + cols.fine() + cell_col);
  }
  /// The face of a cell, or its first triangle.
  [[nodiscard]] int face(Index cell_row, Index cell_col) const {
    return first_face +
           static_cast<int>((cell_row * cols.fine_cells() + cell_col) * (triangles() ? 2 : 1));
  }
  /// The old cell the middle of a new cell lies in; new triangles are cut as it was.
  [[nodiscard]] const GridCell& parent(Index cell_row, Index cell_col) const {
    return coarse.cell(rows.middles[static_cast<std::size_t>(cell_row)].cell,
                       cols.middles[static_cast<std::size_t>(cell_col)].cell);
  }
  /// Which triangle of the parent cell triangle `half` of a fine cell belongs to: the one that
  /// holds the middle of the fine cell, or the corresponding one when that lies on the diagonal.
  [[nodiscard]] int parent_half(Index cell_row, Index cell_col, int half) const;

 private:
  [[nodiscard]] Index edges_per_row() const {
    return cols.fine_cells() + cols.fine() + (triangles() ? cols.fine_cells() : 0);
  }
};

/// What is refined, and how.
struct RebuildOptions {
  const Scheme& along_rows;
  const Scheme& along_cols;
  Boundaries boundaries;
  int levels = 1;
  /// Applied after the last level: limit stencils put the samples on the limit surface.
  std::optional<Stencil> final_along_rows{};
  std::optional<Stencil> final_along_cols{};
};

/// The plan of a whole mesh: all patches and the numbering. Making it checks all there is to check,
/// so that nothing is changed when something is wrong.
///
/// If every patch keeps its old vertices they keep their numbers, and new ones follow patch by
/// patch. Otherwise vertices are numbered anew, patch by patch, and lone vertices come last.
struct Rebuild {
  std::vector<RefinedPatch> patches;
  /// Vertices without faces: old number, new number.
  std::vector<std::pair<int, int>> lone_vertices;
  int old_vertices = 0;
  int vertices = 0;
  int edges = 0;
  int faces = 0;
};

/// \throws InvalidField if the scheme cannot be applied, the boundary rule does not suit a patch,
/// or the result exceeds OpenMesh's 32-bit handles.
[[nodiscard]] Rebuild plan_rebuild(std::vector<GridPatch> patches, int old_vertices,
                                   const RebuildOptions& options);

}  // namespace arete::openmesh::detail
