// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <vector>

#include "arete/reverse/mesh_recover.h"

namespace arete::recovery {

// What the recoveries of the three schemes share: labels spread from one face, the coarse mesh is
// read off, and then checked by subdividing it.

using Labels = std::vector<int>;
constexpr int unknown = -1;

/// A coarse mesh as read off, on the fine mesh's vertex numbers.
struct Draft {
  std::vector<Index> vertices;                        ///< the fine vertices of the coarse ones
  std::vector<std::vector<Index>> faces;              ///< over those
  std::vector<Index> face_points;                     ///< Catmull-Clark: one for each face
  std::map<MeshNeighbours::Edge, Index> edge_points;  ///< by the ends' fine vertices
};

/// Whether subdividing `coarse` gives the fine mesh, with fine vertex i at place[i].
[[nodiscard]] bool fits(const MeshFaces& fine, const MeshFaces& coarse,
                        const std::vector<Index>& place, MeshScheme scheme);

/// The draft with coarse vertices numbered; nothing if it is no mesh or does not fit.
[[nodiscard]] std::optional<RecoveredMesh> finished(const MeshFaces& fine, const Draft& draft,
                                                    MeshScheme scheme);

[[nodiscard]] std::vector<RecoveredMesh> catmull_clark(const MeshFaces& fine,
                                                       const MeshNeighbours& mesh);
[[nodiscard]] std::vector<RecoveredMesh> loop(const MeshFaces& fine, const MeshNeighbours& mesh);
[[nodiscard]] std::vector<RecoveredMesh> doo_sabin(const MeshFaces& fine,
                                                   const MeshNeighbours& mesh);

}  // namespace arete::recovery
