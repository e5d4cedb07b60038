// SPDX-License-Identifier: MIT
#include <array>
#include <set>

#include "arete/reverse/mesh_draft.h"

namespace arete::recovery {
namespace {

// A triangle lies at its corner 0, 1 or 2, or between the others (3).
constexpr int between = 3;

std::optional<Labels> loop_corners(const MeshFaces& fine, const MeshNeighbours& mesh, int first,
                                   Obstacle& obstacle) {
  Labels corner(fine.faces.size(), unknown);
  std::vector<Index> open{0};
  std::size_t reached = 0;
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
          ++reached;
        } else if (label != expected) {
          obstacle.met(reached,
                       "face " + std::to_string(g) + " belongs to no group of four triangles");
          return std::nullopt;
        }
      }
    }
  }
  return corner;
}

std::optional<Draft> loop_draft(const MeshFaces& fine, const MeshNeighbours& mesh,
                                const Labels& corner, Obstacle& obstacle) {
  Draft draft;
  const auto refused = [&](std::size_t f, const char* what) {
    obstacle.met(corner.size(), "face " + std::to_string(f) + what);
    return std::nullopt;
  };
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
      if (beside.size() != 2)
        return refused(f, " should lie between three others but is at the boundary");
      const auto g =
          static_cast<std::size_t>(beside[0] == static_cast<Index>(f) ? beside[1] : beside[0]);
      if (corner[g] == between) return refused(g, " should lie at a corner of the coarse mesh");
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

Recovered loop(const MeshFaces& fine, const MeshNeighbours& mesh, Obstacle& obstacle) {
  Recovered found;
  for (std::size_t f = 0; f < fine.faces.size(); ++f)
    if (fine.faces[f].size() != 3) {
      obstacle.met(0, "face " + std::to_string(f) + " has " + std::to_string(fine.faces[f].size()) +
                          " corners, not 3");
      return found;
    }
  for (int first = 0; first <= between; ++first) {
    const auto corner = loop_corners(fine, mesh, first, obstacle);
    if (!corner) continue;
    const auto draft = loop_draft(fine, mesh, *corner, obstacle);
    if (!draft) continue;
    if (auto result = finished(fine, *draft, MeshScheme::loop, obstacle))
      found.push_back(std::move(*result));
  }
  return found;
}

}  // namespace arete::recovery
