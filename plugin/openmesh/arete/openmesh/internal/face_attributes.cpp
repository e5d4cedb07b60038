// SPDX-License-Identifier: MIT
#include "arete/openmesh/internal/face_attributes.h"

#include <vector>

#include "arete/openmesh/internal/gather.h"

namespace arete::openmesh::detail {
namespace {

std::vector<int> parent_faces(const Rebuild& rebuild) {
  std::vector<int> parents(static_cast<std::size_t>(rebuild.faces));
  for (const RefinedPatch& patch : rebuild.patches) {
    const int halves = patch.triangles() ? 2 : 1;
    for (Index r = 0; r < patch.rows.fine_cells(); ++r) {
      for (Index c = 0; c < patch.cols.fine_cells(); ++c) {
        const GridCell& cell = patch.parent(r, c);
        for (int half = 0; half < halves; ++half) {
          const int from = halves == 1 ? 0 : patch.parent_half(r, c, half);
          parents[static_cast<std::size_t>(patch.face(r, c) + half)] =
              cell.faces[static_cast<std::size_t>(from)];
        }
      }
    }
  }
  return parents;
}

}  // namespace

void refine_face_attributes(OpenMesh::ArrayKernel& mesh, const Rebuild& rebuild,
                            const std::set<const OpenMesh::BaseProperty*>& skipped) {
  std::vector<int> parents;
  for (auto it = mesh.fprops_begin(); it != mesh.fprops_end(); ++it) {
    if (!*it || skipped.count(*it) != 0) continue;
    if (parents.empty()) parents = parent_faces(rebuild);
    gather(**it, parents);
  }
}

}  // namespace arete::openmesh::detail
