// SPDX-License-Identifier: MIT
#include <set>

#include "arete/reverse/mesh_draft.h"

namespace arete::recovery {
namespace {

// A triangle lies at its corner 0, 1 or 2, or between the others (3).
constexpr int between = 3;

std::optional<Labels> loop_corners(const MeshFaces& fine, const MeshNeighbours& mesh, int first) {
  Labels corner(fine.faces.size(), unknown);
  std::vector<Index> open{0};
  corner[0] = first;
  while (!open.empty()) {
    const Index f = open.back();
    open.pop_back();
    const auto& face = fine.faces[static_cast<std::size_t>(f)];
    const int own = corner[static_cast<std::size_t>(f)];
    for (int i = 0; i < 3; ++i) {
      const Index a = face[static_cast<std::size_t>(i)];
      const Index b = face[static_cast<std::size_t>((i + 1) % 3)];
      for (const Index g : mesh.edge_faces(mesh.edge(a, b))) {
        if (g == f) continue;
        const auto& other = fine.faces[static_cast<std::size_t>(g)];
        int expected = between;
        for (int k = 0; k < 3; ++k) {
          const Index v = other[static_cast<std::size_t>(k)];
          const bool same_corner = own < between && v == face[static_cast<std::size_t>(own)];
          const bool across = own == between && v != a && v != b;
          if (same_corner || across) expected = k;
        }
        int& label = corner[static_cast<std::size_t>(g)];
        if (label == unknown) {
          label = expected;
          open.push_back(g);
        } else if (label != expected) {
          return std::nullopt;
        }
      }
    }
  }
  return corner;
}

std::optional<Draft> loop_draft(const MeshFaces& fine, const MeshNeighbours& mesh,
                                const Labels& corner) {
  Draft draft;
  std::set<Index> vertices;
  for (std::size_t f = 0; f < corner.size(); ++f)
    if (corner[f] < between) vertices.insert(fine.faces[f][static_cast<std::size_t>(corner[f])]);
  draft.vertices.assign(vertices.begin(), vertices.end());
  for (std::size_t f = 0; f < corner.size(); ++f) {
    if (corner[f] != between) continue;
    const auto& face = fine.faces[f];
    // The old vertex that the triangle across each side lies at.
    std::array<Index, 3> old{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& beside = mesh.edge_faces(mesh.edge(face[i], face[(i + 1) % 3]));
      if (beside.size() != 2) return std::nullopt;
      const auto g =
          static_cast<std::size_t>(beside[0] == static_cast<Index>(f) ? beside[1] : beside[0]);
      if (corner[g] == between) return std::nullopt;
      old[i] = fine.faces[g][static_cast<std::size_t>(corner[g])];
    }
    // Side i runs between the middles of two old edges that meet at old[i]; face[i] is the middle
    // of the edge from old[i - 1] to old[i].
    draft.faces.push_back({old[2], old[0], old[1]});
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = old[(i + 2) % 3];
      const Index b = old[i];
      draft.edge_points[{std::min(a, b), std::max(a, b)}] = face[i];
    }
  }
  return draft;
}

}  // namespace

std::vector<RecoveredMesh> loop(const MeshFaces& fine, const MeshNeighbours& mesh) {
  std::vector<RecoveredMesh> found;
  for (const auto& face : fine.faces)
    if (face.size() != 3) return found;
  for (int first = 0; first <= between; ++first) {
    const auto corner = loop_corners(fine, mesh, first);
    if (!corner) continue;
    const auto draft = loop_draft(fine, mesh, *corner);
    if (!draft) continue;
    if (auto result = finished(fine, *draft, MeshScheme::loop)) found.push_back(std::move(*result));
  }
  return found;
}

}  // namespace arete::recovery
