// SPDX-License-Identifier: MIT
#pragma once

#include "arete/reverse/mesh_recover.h"

namespace arete {

/// Which elements of a mesh hand their attributes to the coarse mesh. Attributes are not filtered:
/// coarse and left-over values together are those of the given mesh, so any type comes back as it
/// was.

/// The given mesh's vertices: first those that stand for coarse vertices 0, 1, ... (their vertex
/// points; in Doo-Sabin the first of the corners around it), then all others.
[[nodiscard]] std::vector<Index> vertex_order(const RecoveredMesh& mesh, MeshScheme scheme);

/// The given mesh's corners, counted through its faces: first those at the corners of the coarse
/// faces, then all others.
[[nodiscard]] std::vector<Index> corner_order(const RecoveredMesh& mesh, MeshScheme scheme);

/// For every coarse face a face of the given mesh inside it.
[[nodiscard]] std::vector<Index> face_heirs(const RecoveredMesh& mesh, MeshScheme scheme);

}  // namespace arete
