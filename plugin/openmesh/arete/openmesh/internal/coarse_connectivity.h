// SPDX-License-Identifier: MIT
#pragma once

#include <OpenMesh/Core/Mesh/ArrayKernel.hh>

#include "arete/reverse/mesh_attributes.h"

namespace arete::openmesh::detail {

/// Where the elements of a coarse mesh take their properties from, by the numbers of the fine one.
struct CoarseSources {
  std::vector<int> vertices;
  std::vector<int> halfedges;
  std::vector<int> edges;
  std::vector<int> faces;
};

/// The faces of a mesh, each from the half-edge OpenMesh has for it.
[[nodiscard]] MeshFaces plain_faces(const OpenMesh::ArrayKernel& mesh);

/// A half-edge of the coarse mesh takes from the fine one that ends in the same corner of the same
/// face (for numbers OpenMesh keeps a corner's at the half-edge that ends there), an edge from the
/// fine edge that is its half. \pre `fine` is the mesh that was recovered from, unchanged
[[nodiscard]] CoarseSources coarse_sources(const OpenMesh::ArrayKernel& fine,
                                           const RecoveredMesh& recovered, MeshScheme scheme);

/// Gives the mesh these elements and this connectivity, in place; edge e is that of MeshNeighbours,
/// half-edge 2e runs towards its larger vertex. Properties are resized along.
/// \throws InvalidField if the elements exceed OpenMesh's 32-bit handles; nothing is changed then.
void write_connectivity(OpenMesh::ArrayKernel& mesh, const MeshFaces& faces);

}  // namespace arete::openmesh::detail
