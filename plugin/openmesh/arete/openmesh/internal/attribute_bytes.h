// SPDX-License-Identifier: MIT
#pragma once

#include "arete/openmesh/mesh_io.h"
#include "arete/reverse/mesh_details_file.h"

namespace arete::openmesh::detail {

/// Which values of a finer mesh the coarse one holds: the first `kept_...` of each order. The rest
/// waits as bytes in the details.
struct AttributeSplit {
  std::vector<Index> vertices;
  std::size_t kept_vertices = 0;
  std::vector<Index> corners;
  std::size_t kept_corners = 0;
};

/// That of a subdivision step (mesh_attributes.h).
[[nodiscard]] AttributeSplit attribute_split(const RecoveredMesh& mesh, MeshScheme scheme);

/// The names of the attributes that a mesh has.
[[nodiscard]] std::vector<std::string> attribute_names(const MeshData& mesh);

/// The coarse mesh's attributes stay in `mesh`, what it does not hold goes into `level`.
void split_attributes(MeshData& mesh, const AttributeSplit& split, MeshLevelDetails& level);

/// And back. \throws InvalidDetails if `mesh` has other attributes than it was left with.
void join_attributes(MeshData& mesh, const AttributeSplit& split,
                     const std::vector<std::string>& names, const MeshLevelDetails& level);

/// \throws InvalidDetails that says in what the coarse mesh differs.
[[noreturn]] void foreign(const std::string& what);

}  // namespace arete::openmesh::detail
