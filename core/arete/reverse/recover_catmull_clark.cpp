// SPDX-License-Identifier: MIT
#include "arete/reverse/mesh_draft.h"

namespace arete::recovery {
namespace {

// Two colours along edges; nothing if there is an odd cycle.
std::optional<Labels> bipartition(const MeshNeighbours& mesh, Index vertices, Obstacle& obstacle) {
  Labels colour(static_cast<std::size_t>(vertices), unknown);
  std::vector<Index> open{0};
  colour[0] = 0;
  while (!open.empty()) {
    const Index v = open.back();
    open.pop_back();
    for (const Index e : mesh.vertex_edges(v)) {
      const Index w = mesh.other_end(e, v);
      int& other = colour[static_cast<std::size_t>(w)];
      if (other == colour[static_cast<std::size_t>(v)]) {
        obstacle.met(0, "vertices " + std::to_string(v) + " and " + std::to_string(w) +
                            " lie on a closed path of an odd number of edges");
        return std::nullopt;
      }
      if (other != unknown) continue;
      other = 1 - colour[static_cast<std::size_t>(v)];
      open.push_back(w);
    }
  }
  return colour;
}

enum CatmullClarkLabel : int { vertex_point, face_point, edge_point };

// Corners that are no edge points lie opposite each other in a quad: one of each kind.
std::optional<Labels> catmull_clark_labels(const MeshFaces& fine, const MeshNeighbours& mesh,
                                           const Labels& colour, int edge_colour, int first,
                                           Obstacle& obstacle) {
  Labels label(colour.size(), unknown);
  for (std::size_t v = 0; v < colour.size(); ++v) {
    if (colour[v] != edge_colour) continue;
    const auto i = static_cast<Index>(v);
    if (mesh.vertex_edges(i).size() != (mesh.on_boundary(i) ? 3U : 4U)) {
      obstacle.met(v, "vertex " + std::to_string(v) + " should be an edge point but has valence " +
                          std::to_string(mesh.vertex_edges(i).size()));
      return std::nullopt;
    }
    label[v] = edge_point;
  }
  std::vector<Index> open;
  for (const Index v : fine.faces.front())
    if (open.empty() && label[static_cast<std::size_t>(v)] != edge_point) open.push_back(v);
  label[static_cast<std::size_t>(open.front())] = first;
  while (!open.empty()) {
    const Index v = open.back();
    open.pop_back();
    for (const Index f : mesh.vertex_faces(v)) {
      const auto& face = fine.faces[static_cast<std::size_t>(f)];
      const auto place =
          static_cast<std::size_t>(std::find(face.begin(), face.end(), v) - face.begin());
      const Index across = face[(place + 2) % 4];
      int& other = label[static_cast<std::size_t>(across)];
      if (other == label[static_cast<std::size_t>(v)]) {
        obstacle.met(colour.size(),
                     "face " + std::to_string(f) + " has two vertex points or two face points");
        return std::nullopt;
      }
      if (other != unknown) continue;
      other = label[static_cast<std::size_t>(v)] == vertex_point ? face_point : vertex_point;
      open.push_back(across);
    }
  }
  return label;
}

std::optional<Draft> catmull_clark_draft(const MeshFaces& fine, const MeshNeighbours& mesh,
                                         const Labels& label, Obstacle& obstacle) {
  Draft draft;
  const auto refused = [&](Index v, const char* what) {
    obstacle.met(2 * label.size(), "vertex " + std::to_string(v) + what);
    return std::nullopt;
  };
  for (std::size_t i = 0; i < label.size(); ++i) {
    const auto v = static_cast<Index>(i);
    if (label[i] == vertex_point) draft.vertices.push_back(v);
    if (label[i] == edge_point) {
      std::vector<Index> ends;
      for (const Index e : mesh.vertex_edges(v)) {
        const Index w = mesh.other_end(e, v);
        if (label[static_cast<std::size_t>(w)] == vertex_point) ends.push_back(w);
      }
      if (ends.size() != 2) return refused(v, " should be an edge point between two vertex points");
      draft.edge_points[{std::min(ends[0], ends[1]), std::max(ends[0], ends[1])}] = v;
    }
    if (label[i] != face_point) continue;
    // Quads at a face point run: face point, edge point before, vertex, edge point behind.
    std::map<Index, std::pair<Index, Index>> behind;
    for (const Index f : mesh.vertex_faces(v)) {
      const auto face = fine.faces[static_cast<std::size_t>(f)];
      const auto place =
          static_cast<std::size_t>(std::find(face.begin(), face.end(), v) - face.begin());
      behind[face[(place + 1) % 4]] = {face[(place + 2) % 4], face[(place + 3) % 4]};
    }
    std::vector<Index> corners;
    Index at = behind.begin()->first;
    for (std::size_t k = 0; k < behind.size(); ++k) {
      const auto next = behind.find(at);
      if (next == behind.end()) return refused(v, " is a face point at the boundary");
      corners.push_back(next->second.first);
      at = next->second.second;
    }
    if (at != behind.begin()->first) return refused(v, " is no face point of one face");
    draft.faces.push_back(std::move(corners));
    draft.face_points.push_back(v);
  }
  return draft;
}

}  // namespace

Recovered catmull_clark(const MeshFaces& fine, const MeshNeighbours& mesh, Obstacle& obstacle) {
  Recovered found;
  for (std::size_t f = 0; f < fine.faces.size(); ++f)
    if (fine.faces[f].size() != 4) {
      obstacle.met(0, "face " + std::to_string(f) + " has " + std::to_string(fine.faces[f].size()) +
                          " corners, not 4");
      return found;
    }
  const auto colour = bipartition(mesh, fine.vertices, obstacle);
  if (!colour) return found;
  for (const int edge_colour : {0, 1})
    for (const int first : {vertex_point, face_point}) {
      const auto label = catmull_clark_labels(fine, mesh, *colour, edge_colour, first, obstacle);
      if (!label) continue;
      const auto draft = catmull_clark_draft(fine, mesh, *label, obstacle);
      if (!draft) continue;
      if (auto result = finished(fine, *draft, MeshScheme::catmull_clark, obstacle))
        found.push_back(std::move(*result));
    }
  return found;
}

}  // namespace arete::recovery
