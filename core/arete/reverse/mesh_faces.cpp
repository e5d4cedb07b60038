// SPDX-License-Identifier: MIT
#include "arete/reverse/mesh_faces.h"

#include <map>
#include <numeric>
#include <string>

namespace arete {
namespace {

std::string face_text(std::size_t face) { return "face " + std::to_string(face); }

}  // namespace

MeshFaces mesh_faces(Index vertices, const FaceList& faces) {
  MeshFaces mesh{vertices, {}};
  for (int f = 0; f < faces.count(); ++f) mesh.faces.emplace_back(faces[f].begin(), faces[f].end());
  return mesh;
}

FaceList face_list(const MeshFaces& mesh) {
  FaceList list;
  std::vector<int> corners;
  for (const auto& face : mesh.faces) {
    corners.assign(face.begin(), face.end());
    list.add(corners);
  }
  return list;
}

MeshNeighbours::MeshNeighbours(const MeshFaces& mesh)
    : vertex_edges_(static_cast<std::size_t>(mesh.vertices)),
      vertex_faces_(static_cast<std::size_t>(mesh.vertices)) {
  struct Side {
    Edge edge;
    bool backwards;
    Index face;
    auto operator<=>(const Side&) const = default;
  };
  std::vector<Side> sides;
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
      sides.push_back({{std::min(a, b), std::max(a, b)}, a > b, static_cast<Index>(f)});
      vertex_faces_[static_cast<std::size_t>(a)].push_back(static_cast<Index>(f));
    }
  }
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Side& side = sides[i];
    if (i == 0 || side.edge != sides[i - 1].edge) {
      for (const Index v : side.edge)
        vertex_edges_[static_cast<std::size_t>(v)].push_back(edge_count());
      edges_.push_back(side.edge);
      edge_faces_.emplace_back();
    } else if (side.backwards == sides[i - 1].backwards) {
      const Edge way = side.backwards ? Edge{side.edge[1], side.edge[0]} : side.edge;
      throw InvalidField("the edge from vertex " + std::to_string(way[0]) + " to " +
                         std::to_string(way[1]) + " is in two faces the same way (" +
                         face_text(static_cast<std::size_t>(side.face)) +
                         " is one); orient the mesh and split what is not manifold");
    }
    edge_faces_.back().push_back(side.face);
  }
  for (auto& faces : edge_faces_) std::sort(faces.begin(), faces.end());
  check_fans(mesh);
}

// Around a vertex its faces must hang together edge by edge: one fan, closed or open.
void MeshNeighbours::check_fans(const MeshFaces& mesh) const {
  std::vector<Index> reached;
  for (Index v = 0; v < mesh.vertices; ++v) {
    const auto& faces = vertex_faces(v);
    if (faces.empty())
      throw InvalidField("vertex " + std::to_string(v) + " is in no face; remove it");
    reached.assign({faces.front()});
    for (std::size_t i = 0; i < reached.size(); ++i)
      for (const Index e : vertex_edges(v)) {
        const auto& beside = edge_faces(e);
        if (std::find(beside.begin(), beside.end(), reached[i]) == beside.end()) continue;
        for (const Index g : beside)
          if (std::find(reached.begin(), reached.end(), g) == reached.end()) reached.push_back(g);
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
