// SPDX-License-Identifier: MIT
#pragma once

#include "arete/openmesh/mesh_io.h"
#include "arete/field/grid.h"

namespace arete::openmesh::detail {

/// x, y, z, one vertex a row. \throws InvalidField naming a vertex that is not finite.
[[nodiscard]] Grid<double> positions_of(const MeshData& mesh);
void set_points(MeshData& mesh, const Grid<double>& positions);

}  // namespace arete::openmesh::detail
