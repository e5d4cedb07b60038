// SPDX-License-Identifier: MIT
#pragma once

#include <OpenMesh/Core/Mesh/ArrayKernel.hh>
#include <set>

#include "arete/openmesh/internal/rebuild.h"

namespace arete::openmesh::detail {

/// Gives every new face the properties of the old face the middle of its cell lies in, but for
/// those in `skipped`. To be called before the mesh has its new elements.
void refine_face_attributes(OpenMesh::ArrayKernel& mesh, const Rebuild& rebuild,
                            const std::set<const OpenMesh::BaseProperty*>& skipped);

}  // namespace arete::openmesh::detail
