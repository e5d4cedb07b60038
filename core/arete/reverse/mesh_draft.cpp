// SPDX-License-Identifier: MIT
#include "arete/reverse/mesh_draft.h"

#include <set>

namespace arete::recovery {
namespace {

// A face is known by the side that leaves its lowest vertex: no other face has that side.
struct Key {
  Index lowest;
  Index next;
  std::size_t face;
  Index turn;  // the corner that is the lowest vertex
  [[nodiscard]] auto side() const { return std::pair(lowest, next); }
};

std::vector<Key> keys_of(const std::vector<std::vector<Index>>& faces) {
  std::vector<Key> keys;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto& face = faces[f];
    const auto lowest = std::min_element(face.begin(), face.end());
    const auto turn = static_cast<std::size_t>(lowest - face.begin());
    keys.push_back({*lowest, face[(turn + 1) % face.size()], f, static_cast<Index>(turn)});
  }
  std::sort(keys.begin(), keys.end(),
            [](const Key& a, const Key& b) { return a.side() < b.side(); });
  return keys;
}

}  // namespace

bool fits(const MeshFaces& fine, RecoveredMesh& mesh, MeshScheme scheme) {
  const auto& place = mesh.place;
  MeshFaces again = mesh.step_faces(scheme);
  if (again.vertices != fine.vertices || again.faces.size() != fine.faces.size() ||
      static_cast<Index>(place.size()) != fine.vertices ||
      std::set<Index>(place.begin(), place.end()).size() != place.size())
    return false;
  for (auto& face : again.faces)
    for (Index& v : face) v = place[static_cast<std::size_t>(v)];
  const std::vector<Key> wanted = keys_of(fine.faces);
  const std::vector<Key> found = keys_of(again.faces);
  mesh.faces.resize(fine.faces.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const auto& face = fine.faces[wanted[i].face];
    const auto& same = again.faces[found[i].face];
    const auto corners = static_cast<Index>(face.size());
    if (same.size() != face.size()) return false;
    const Index turn = (found[i].turn - wanted[i].turn + corners) % corners;
    for (Index k = 0; k < corners; ++k)
      if (face[static_cast<std::size_t>(k)] != same[static_cast<std::size_t>((k + turn) % corners)])
        return false;
    mesh.faces[wanted[i].face] = {static_cast<Index>(found[i].face), turn};
  }
  return true;
}

std::optional<RecoveredMesh> finished(const MeshFaces& fine, const Draft& draft, MeshScheme scheme,
                                      Obstacle& obstacle) {
  try {
    std::map<Index, Index> number;
    for (const Index v : draft.vertices) number.emplace(v, static_cast<Index>(number.size()));
    RecoveredMesh result;
    result.coarse.vertices = static_cast<Index>(number.size());
    for (const auto& face : draft.faces) {
      std::vector<Index> corners;
      for (const Index v : face) {
        const auto found = number.find(v);
        if (found == number.end()) return std::nullopt;
        corners.push_back(found->second);
      }
      result.coarse.faces.push_back(std::move(corners));
    }
    const MeshNeighbours mesh(result.coarse);
    result.place = draft.vertices;
    result.place.insert(result.place.end(), draft.face_points.begin(), draft.face_points.end());
    for (const auto& [a, b] : mesh.edges()) {
      const Index from = draft.vertices[static_cast<std::size_t>(a)];
      const Index to = draft.vertices[static_cast<std::size_t>(b)];
      const auto point = draft.edge_points.find({std::min(from, to), std::max(from, to)});
      if (point == draft.edge_points.end()) return std::nullopt;
      result.place.push_back(point->second);
    }
    if (fits(fine, result, scheme)) return result;
    obstacle.met(fine.faces.size(), "the coarse mesh read off refines to another mesh");
  } catch (const InvalidField& error) {  // not a manifold, or not of triangles
    obstacle.met(fine.faces.size(), std::string("in the coarse mesh read off ") + error.what());
  }
  return std::nullopt;
}

}  // namespace arete::recovery
