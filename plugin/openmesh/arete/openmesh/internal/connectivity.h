// SPDX-License-Identifier: MIT
#pragma once

#include <OpenMesh/Core/Mesh/ArrayKernel.hh>

#include "arete/openmesh/internal/rebuild.h"

namespace arete::openmesh::detail {

/// Gives the mesh the elements and connectivity of the plan, in place and without going through the
/// levels between: every half-edge is written once, where it belongs, nothing is searched.
/// Properties are resized along with the elements; what they hold is the caller's business.
/// The result does not depend on the number of threads.
void build_connectivity(OpenMesh::ArrayKernel& mesh, const Rebuild& rebuild, int threads = 1);

}  // namespace arete::openmesh::detail
