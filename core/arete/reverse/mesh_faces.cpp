// SPDX-License-Identifier: MIT
#include "arete/reverse/mesh_faces.h"

#include <numeric>
#include <set>
#include <string>

namespace arete {
namespace {

std::string face_text(std::size_t face) { return "face " + std::to_string(face); }

}  // namespace

MeshNeighbours::MeshNeighbours(const MeshFaces& mesh)
    : vertex_edges_(static_cast<std::size_t>(mesh.vertices)),
      vertex_faces_(static_cast<std::size_t>(mesh.vertices)) {
  std::set<Edge> directed;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& face = mesh.faces[f];
    if (face.size() < 3)
      throw InvalidField(face_text(f) + " has " + std::to_string(face.size()) +
                         " vertices; a face needs three");
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Index a = face[i];
      const Index b = face[(i + 1) % face.size()];
      if (a < 0 || a >= mesh.vertices)
        throw InvalidField(face_text(f) + " names vertex " + std::to_string(a) + " of " +
                           std::to_string(mesh.vertices));
      if (std::count(face.begin(), face.end(), a) != 1)
        throw InvalidField(face_text(f) + " has vertex " + std::to_string(a) + " twice");
      if (!directed.insert({a, b}).second)
        throw InvalidField("the edge from vertex " + std::to_string(a) + " to " +
                           std::to_string(b) + " is in two faces the same way (" + face_text(f) +
                           " is one); orient the mesh and split what is not manifold");
      edge_of_.emplace(Edge{std::min(a, b), std::max(a, b)}, 0);
      vertex_faces_[static_cast<std::size_t>(a)].push_back(static_cast<Index>(f));
    }
  }
  for (auto& [edge, number] : edge_of_) {
    number = edge_count();
    edges_.push_back(edge);
    for (const Index v : edge) vertex_edges_[static_cast<std::size_t>(v)].push_back(number);
  }
  edge_faces_.resize(edges_.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& face = mesh.faces[f];
    for (std::size_t i = 0; i < face.size(); ++i)
      edge_faces_[static_cast<std::size_t>(edge(face[i], face[(i + 1) % face.size()]))].push_back(
          static_cast<Index>(f));
  }
  check_fans(mesh);
}

// Around a vertex its faces must hang together edge by edge: one fan, closed or open.
void MeshNeighbours::check_fans(const MeshFaces& mesh) const {
  for (Index v = 0; v < mesh.vertices; ++v) {
    const auto& faces = vertex_faces(v);
    if (faces.empty())
      throw InvalidField("vertex " + std::to_string(v) + " is in no face; remove it");
    std::set<Index> reached{faces.front()};
    std::vector<Index> open{faces.front()};
    while (!open.empty()) {
      const Index f = open.back();
      open.pop_back();
      for (const Index e : vertex_edges(v)) {
        const auto& beside = edge_faces(e);
        if (std::find(beside.begin(), beside.end(), f) == beside.end()) continue;
        for (const Index g : beside)
          if (reached.insert(g).second) open.push_back(g);
      }
    }
    if (reached.size() != faces.size())
      throw InvalidField("the faces around vertex " + std::to_string(v) +
                         " do not hang together; split the vertex");
  }
}

std::vector<std::vector<Index>> connected_faces(const MeshFaces& mesh) {
  std::vector<Index> parent(static_cast<std::size_t>(mesh.vertices));
  std::iota(parent.begin(), parent.end(), Index{0});
  const auto root = [&](Index v) {
    while (parent[static_cast<std::size_t>(v)] != v) {
      Index& up = parent[static_cast<std::size_t>(v)];
      up = parent[static_cast<std::size_t>(up)];
      v = up;
    }
    return v;
  };
  for (const auto& face : mesh.faces)
    for (const Index v : face) parent[static_cast<std::size_t>(root(v))] = root(face.front());
  std::map<Index, std::vector<Index>> parts;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    parts[root(mesh.faces[f].front())].push_back(static_cast<Index>(f));
  std::vector<std::vector<Index>> result;
  for (auto& [first, faces] : parts) result.push_back(std::move(faces));
  return result;
}

}  // namespace arete
