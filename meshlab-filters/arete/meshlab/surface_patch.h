// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "arete/meshlab/mesh_arrays.h"
#include "arete/meshlab/progress.h"
#include "arete/topology/grid_patch.h"

namespace arete::meshlab {

/// The grids a mesh is made of, one a connected part. Every cell of a patch knows its two triangles
/// and its diagonal, rows run south and columns east where the plan view allows (see oriented()).
///
/// Polygon bits are a hint: where they pair all triangles into quads that form grids, they settle
/// what is a cell (and allow tubes and tori); otherwise the triangles alone must form grids, which
/// is said in the log.
///
/// \throws InvalidField naming the vertex or face and the remedy, for a mesh without faces, a
/// coordinate that is not finite, and whatever is no grid.
[[nodiscard]] std::vector<GridPatch> surface_patches(const MeshArrays& mesh, Report& report);

}  // namespace arete::meshlab
