// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "arete/variational/surface_mesh.h"

namespace arete {

struct RelaxOptions {
  /// Pinkall-Polthier steps first: all coordinates free. They spread the points evenly and repair a
  /// bad start, but drift along the surface for ever.
  int spreading_steps = 3;
  /// Normal steps at most after them.
  int normal_steps = 60;
  /// Ends when max |H| times the square root of the area is below it.
  double tolerance = 1e-7;
  /// Called after every step with its number and the area; may throw to stop.
  std::function<void(int step, double area)> progress{};
};

struct RelaxReport {
  std::vector<double> areas;  ///< before the first and after every step; never rises
  double max_mean_curvature = 0;
  bool converged = false;  ///< the tolerance was reached
};

/// Moves the free points of a mesh until its area is stationary (Plateau's problem).
///
/// With the cotangent Laplacian L of the present surface X, its area is A(X) = E_D(X) = 1/2 sum_k
/// x_k^T L x_k. A Pinkall-Polthier step minimises E_D over the positions of the free points (solves
/// L y = 0 inside); a normal step minimises it over X + phi n, n the unit normals:
/// (N^T L N) phi = -N^T L X. Either minimises E_D over a set that contains X, and the area of a
/// surface is at most its E_D, so THE AREA NEVER RISES; normal steps do not let the points slide.
/// (Pinkall, Polthier, "Computing discrete minimal surfaces and their conjugates", 1993.)
///
/// A step that rounding would make larger by more than 1e-12 of the area is not taken and ends the
/// work. Connected meshes without fixed points shrink to a point and are refused. A boundary that
/// no connected surface spans (two rings too far apart) makes the neck collapse: the area still
/// falls, max_mean_curvature stays large, converged is false.
///
/// One sparse Cholesky factorisation of the free points a step. \throws InvalidField see
/// check_mesh; if a free point has no way to a fixed one; if the surface has no area.
RelaxReport relax(SurfaceMesh& mesh, const RelaxOptions& options = {});

}  // namespace arete
