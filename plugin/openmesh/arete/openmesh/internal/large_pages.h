// SPDX-License-Identifier: MIT
#pragma once

#include <OpenMesh/Core/Mesh/ArrayKernel.hh>

namespace arete::openmesh::detail {

/// mesh.reserve(), and where the system can (Linux with transparent huge pages) large memory pages
/// for what is reserved: of the time to fill a fresh mesh more than half goes into page faults.
/// Nothing else changes. Properties of types nobody knows are reserved as usual.
void reserve_in_large_pages(OpenMesh::ArrayKernel& mesh, std::size_t vertices, std::size_t edges,
                            std::size_t faces);

}  // namespace arete::openmesh::detail
