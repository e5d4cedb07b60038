// SPDX-License-Identifier: MIT
#include "arete/reverse/mesh_draft.h"

#include <set>

namespace arete::recovery {
namespace {

std::vector<Index> turned(std::vector<Index> face) {
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

std::multiset<std::vector<Index>> all_turned(const std::vector<std::vector<Index>>& faces) {
  std::multiset<std::vector<Index>> result;
  for (const auto& face : faces) result.insert(turned(face));
  return result;
}

}  // namespace

bool fits(const MeshFaces& fine, const MeshFaces& coarse, const std::vector<Index>& place,
          MeshScheme scheme) {
  MeshFaces again = mesh_step<double>(coarse, scheme).fine;
  if (again.vertices != fine.vertices || static_cast<Index>(place.size()) != fine.vertices ||
      std::set<Index>(place.begin(), place.end()).size() != place.size())
    return false;
  for (auto& face : again.faces)
    for (Index& v : face) v = place[static_cast<std::size_t>(v)];
  return all_turned(again.faces) == all_turned(fine.faces);
}

std::optional<RecoveredMesh> finished(const MeshFaces& fine, const Draft& draft,
                                      MeshScheme scheme) {
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
    if (!fits(fine, result.coarse, result.place, scheme)) return std::nullopt;
    return result;
  } catch (const InvalidField&) {
    return std::nullopt;  // not a manifold, or not of triangles
  }
}

}  // namespace arete::recovery
