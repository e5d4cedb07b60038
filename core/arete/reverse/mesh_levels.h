// SPDX-License-Identifier: MIT
#pragma once

#include "arete/reverse/mesh_recover.h"
#include "arete/reverse/threshold.h"

namespace arete {

/// Several steps, and their details thinned.
///
/// Levels of a mesh taken apart, the finest first.
using MeshLevels = std::vector<MeshDecomposition<double>>;

/// Takes `levels` steps; the rule of the first one holds for all. \throws InvalidField as
/// decompose_mesh, saying how many steps could be taken.
[[nodiscard]] MeshLevels decompose_mesh_levels(const MeshFaces& fine,
                                               GridView<const double> positions,
                                               const std::vector<MeshRule>& rules, ReverseMode mode,
                                               int levels);

/// The positions of the mesh that was taken apart.
[[nodiscard]] Grid<double> reconstruct_mesh_levels(const MeshLevels& levels);

/// Sets details no longer than `threshold` to zero, rounds the others to float32 and forgets the
/// remainders. \throws InvalidField for a negative threshold or one that is not finite.
void drop_details(MeshLevels& levels, double threshold);

/// How many detail vectors there are, and how many are not zero.
[[nodiscard]] DetailCount count_details(const MeshLevels& levels);

/// Of distances between vertices: root mean square and largest.
[[nodiscard]] RestoreError restore_error(const Grid<double>& restored,
                                         GridView<const double> positions);

/// The largest threshold found by bisection (to 1/1000 of itself) whose restored mesh has an RMSE
/// of at most `target`; 0 if even that drops too much. \throws InvalidField for a negative target.
[[nodiscard]] double threshold_for_rmse(const MeshLevels& levels, GridView<const double> positions,
                                        double target);

}  // namespace arete
