// SPDX-License-Identifier: MIT
#pragma once

#include <OpenMesh/Core/Mesh/ArrayKernel.hh>
#include <set>

#include "arete/openmesh/internal/rebuild.h"

namespace arete::openmesh::detail {

/// Gives every new edge that lies on an old one its properties, and the others default values
/// (zeros, no flags). The same for those half-edge properties that are no numbers, along their own
/// direction. To be called before the mesh has its new elements.
void refine_edge_attributes(OpenMesh::ArrayKernel& mesh, const Rebuild& rebuild,
                            const std::set<const OpenMesh::BaseProperty*>& skipped);

}  // namespace arete::openmesh::detail
