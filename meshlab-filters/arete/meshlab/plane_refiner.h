// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "arete/meshlab/mesh_arrays.h"
#include "arete/meshlab/progress.h"
#include "arete/refine/refiner.h"
#include "arete/topology/grid_patch.h"

namespace arete::meshlab {

/// One coordinate (0 x, 1 y, 2 z) of a patch, row by row.
[[nodiscard]] Grid<double> coordinate_plane(const MeshArrays& mesh, const GridPatch& patch,
                                            std::size_t coordinate);

/// The plane refined on all cores, in bands between which progress from `begin` to `end` percent is
/// told. \throws Cancelled
[[nodiscard]] Grid<double> refined_plane(const Refiner<double>& refiner, const Grid<double>& plane,
                                         const Report& report, int begin, int end);

}  // namespace arete::meshlab
