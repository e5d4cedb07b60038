// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "arete/field/grid.h"
#include "arete/variational/relax.h"

namespace arete {

/// The boundary of a patch over the unit square, asked for at points of its border only: u runs
/// along columns, v along rows, 0..1. A ring has two boundary curves, v = 0 and v = 1, closed in u
/// (at(1, v) = at(0, v), never asked).
struct PatchBoundary {
  std::function<Point3(double u, double v)> at;
  bool ring = false;
};

struct MinimalOptions {
  /// How often the coarsest grid is refined; each level has twice as many cells a side.
  int levels = 4;
  int start_rows = 4;  ///< cells of the coarsest grid from v = 0 to v = 1
  /// Cells along u; 0: 4, and 16 around a ring (with few of them the coarse ring has corners, is
  /// narrower than the true one, and its neck may collapse where the true one's does not).
  int start_cols = 0;
  RelaxOptions relax{};  ///< of the last level; earlier ones are not worked out so far
};

/// What was done on one level.
struct MinimalLevel {
  Extent samples;
  double start_area = 0;  ///< after refining the level before and re-sampling the boundary
  double area = 0;
  double max_mean_curvature = 0;
  int steps = 0;
  bool converged = false;
};

/// A surface over a grid of samples, row by row; of a ring the columns close.
struct MinimalSurface {
  SurfaceMesh mesh;
  Extent samples;
  bool ring = false;
  std::vector<MinimalLevel> levels;
};

/// The grid's triangles: every quad (r, c) .. (r+1, c+1) cut from (r, c) to (r+1, c+1).
[[nodiscard]] std::vector<std::array<int, 3>> grid_triangles(Extent samples, bool ring);

/// The bilinearly blended Coons patch of the boundary: the sum of the two ruled surfaces minus the
/// bilinear one of the corners; of a ring the ruled surface between its curves. The first row has
/// v = 0. \throws InvalidField below 2 x 2 samples (ring: 2 x 3).
[[nodiscard]] std::vector<Point3> coons_patch(const PatchBoundary& boundary, Extent samples);

/// A surface of least area with the given boundary (Plateau's problem), from coarse to fine: a
/// Coons patch is relaxed (relax.h), refined at the middles of edges and quads, its border taken
/// from the boundary again, relaxed, and so on. On one level the area never rises; the area error
/// and the distance to the true surface fall as the square of the spacing (catenoid, Enneper,
/// Scherk, helicoid: 4.0 times a level).
///
/// The solution of Plateau's problem need not be unique, and a ring may have none (two equal
/// rings further apart than 1.3254 radii): see `converged` of the last level.
/// \throws InvalidField for levels outside 0..10, fewer than 1 start cell (around a ring: 3), more
/// than 4096 cells a side, a boundary that is not finite or spans no area.
[[nodiscard]] MinimalSurface minimal_surface(const PatchBoundary& boundary,
                                             const MinimalOptions& options = {});

}  // namespace arete
