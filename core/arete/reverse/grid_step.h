// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "arete/field/boundary.h"
#include "arete/reverse/axis_reverse.h"
#include "arete/reverse/mesh_faces.h"
#include "arete/scheme/scheme.h"

namespace arete {

/// One step of a scheme of the catalogue on the vertices of a regular grid of quads: what mesh_step
/// is to schemes for meshes.
///
/// Coarse vertices are numbered row by row. Fine ones: first those that stand for the coarse ones
/// (the nearest, each for one), in their order, then all others row by row. Faces are those of
/// grid_faces.
struct GridStep {
  Scheme scheme;
  Boundaries boundaries;  ///< periodic along an axis that wraps, and only there
  Extent fine;            ///< in vertices
  bool mirrored = false;  ///< see grid_faces

  [[nodiscard]] bool wraps_rows() const { return boundaries.y == Boundary::periodic; }
  [[nodiscard]] bool wraps_cols() const { return boundaries.x == Boundary::periodic; }
  /// \throws InvalidField for an axis that has no shorter grid of quads.
  [[nodiscard]] Extent coarse() const;
  /// The step before this one. \throws InvalidField as coarse().
  [[nodiscard]] GridStep coarser() const { return {scheme, boundaries, coarse(), mirrored}; }

  [[nodiscard]] MeshFaces coarse_faces() const;
  /// Over the step's own order of fine vertices.
  [[nodiscard]] MeshFaces fine_faces() const;
  /// Fine vertex i of the step is vertex order()[i] of the fine grid, row by row.
  [[nodiscard]] std::vector<Index> order() const;
  /// For every corner of every coarse face a fine face in it, which has the same corner.
  [[nodiscard]] std::vector<Index> corner_faces() const;

  /// One vertex a row, in the step's order. \throws InvalidField if there are not as many coarse
  /// positions as vertices.
  [[nodiscard]] Grid<double> subdivided(GridView<const double> coarse_positions) const;
  /// The coarse positions. \throws InvalidField as subdivided() and AxisReverse.
  [[nodiscard]] Grid<double> reversed(GridView<const double> fine_positions,
                                      ReverseMode mode) const;
};

}  // namespace arete
