// SPDX-License-Identifier: MIT
#pragma once

#include "arete/reverse/grid_reverse.h"
#include "arete/reverse/mesh_levels.h"

namespace arete {

/// Meshes that are one regular grid of quads, taken apart by any scheme of the catalogue: x, y and
/// z are grids, and their reverse is that of grids (grid_reverse.h). An axis that wraps is closed;
/// which of its vertices were vertices of the coarse grid is found by the smallest details.
///
/// Finds rows and columns by topology (recover.h), turned as `refine` turns them (orient.h), so
/// that whatever `refine` made from a grid comes back. `boundaries` are those of axes with an end.
/// Each step's RecoveredMesh::grid says how it was done; coarse vertices and faces are numbered row
/// by row. Details are kept for every fine vertex, as those of other meshes. \throws InvalidField
/// when the mesh is no such grid, naming the first vertex or face that does not fit, when an axis
/// is too short, or when the scheme has no such reverse, and for `periodic` along an axis with an
/// end.
[[nodiscard]] MeshLevels decompose_grid_mesh(const MeshFaces& fine,
                                             GridView<const double> positions, const Scheme& scheme,
                                             Boundaries boundaries, ReverseMode mode, int levels);

}  // namespace arete
