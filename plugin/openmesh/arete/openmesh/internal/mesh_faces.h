// SPDX-License-Identifier: MIT
#pragma once

#include <OpenMesh/Core/Mesh/ArrayKernel.hh>
#include <cstdint>

#include "arete/topology/face_list.h"

namespace arete::openmesh::detail {

/// The faces of a mesh as plain numbers. \throws InvalidField if elements are marked as deleted but
/// still there, because their handles would stand in the way.
[[nodiscard]] FaceList mesh_faces(const OpenMesh::ArrayKernel& mesh);

/// A number that changes when the connectivity does.
[[nodiscard]] std::uint64_t fingerprint(const OpenMesh::ArrayKernel& mesh);

}  // namespace arete::openmesh::detail
