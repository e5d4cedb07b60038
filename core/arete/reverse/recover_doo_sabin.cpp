// SPDX-License-Identifier: MIT
#include "arete/reverse/mesh_draft.h"

namespace arete::recovery {
namespace {

enum DooSabinLabel : int { of_face, of_edge, of_vertex };

// The faces around a vertex in order.
std::vector<Index> faces_around(const MeshFaces& fine, const MeshNeighbours& mesh, Index v) {
  std::vector<Index> around;
  Index f = mesh.vertex_faces(v).front();
  for (std::size_t i = 0; i < mesh.vertex_faces(v).size(); ++i) {
    around.push_back(f);
    const auto& face = fine.faces[static_cast<std::size_t>(f)];
    const auto place =
        static_cast<std::size_t>(std::find(face.begin(), face.end(), v) - face.begin());
    const auto& beside =
        mesh.edge_faces(mesh.edge(face[(place + face.size() - 1) % face.size()], v));
    f = beside[0] == f ? beside[1] : beside[0];
  }
  return around;
}

std::optional<Labels> doo_sabin_labels(const std::vector<std::vector<Index>>& around,
                                       const MeshFaces& fine, std::size_t first,
                                       Obstacle& obstacle) {
  Labels label(fine.faces.size(), unknown);
  std::vector<Index> open;
  std::size_t reached = 0;
  label[static_cast<std::size_t>(around[0][first])] = of_face;
  open.push_back(around[0][first]);
  while (!open.empty()) {
    const Index f = open.back();
    open.pop_back();
    for (const Index v : fine.faces[static_cast<std::size_t>(f)]) {
      const auto& ring = around[static_cast<std::size_t>(v)];
      const auto place =
          static_cast<std::size_t>(std::find(ring.begin(), ring.end(), f) - ring.begin());
      for (std::size_t k = 1; k < 4; ++k) {
        const Index g = ring[(place + k) % 4];
        const int expected =
            k != 2 ? of_edge
                   : (label[static_cast<std::size_t>(f)] == of_face ? of_vertex : of_face);
        int& other = label[static_cast<std::size_t>(g)];
        if (other != unknown && other != expected) {
          obstacle.met(reached, "face " + std::to_string(g) +
                                    " should be both a face's, an edge's or a vertex's");
          return std::nullopt;
        }
        if (other == unknown) ++reached;
        if (other == unknown && expected != of_edge) open.push_back(g);
        other = expected;
      }
    }
  }
  return label;
}

std::optional<RecoveredMesh> doo_sabin_mesh(const std::vector<std::vector<Index>>& around,
                                            const MeshFaces& fine, const Labels& label,
                                            Obstacle& obstacle) {
  RecoveredMesh result;
  std::map<Index, Index> number;
  for (std::size_t f = 0; f < label.size(); ++f)
    if (label[f] == of_vertex)
      number.emplace(static_cast<Index>(f), static_cast<Index>(number.size()));
  result.coarse.vertices = static_cast<Index>(number.size());
  for (std::size_t f = 0; f < label.size(); ++f) {
    if (label[f] != of_face) continue;
    std::vector<Index> corners;
    for (const Index v : fine.faces[f]) {
      for (const Index g : around[static_cast<std::size_t>(v)])
        if (label[static_cast<std::size_t>(g)] == of_vertex) corners.push_back(number.at(g));
      result.place.push_back(v);
    }
    result.coarse.faces.push_back(std::move(corners));
  }
  try {
    if (fits(fine, result, MeshScheme::doo_sabin)) return result;
    obstacle.met(label.size(), "the coarse mesh read off refines to another mesh");
  } catch (const InvalidField& error) {
    obstacle.met(label.size(), std::string("in the coarse mesh read off ") + error.what());
  }
  return std::nullopt;
}

}  // namespace

Recovered doo_sabin(const MeshFaces& fine, const MeshNeighbours& mesh, Obstacle& obstacle) {
  Recovered found;
  std::vector<std::vector<Index>> around;
  for (Index v = 0; v < fine.vertices; ++v) {
    if (mesh.on_boundary(v))
      throw InvalidField("vertex " + std::to_string(v) +
                         " lies on a boundary; the reverse of Doo-Sabin is for closed meshes");
    around.push_back(faces_around(fine, mesh, v));
    if (around.back().size() != 4) {
      obstacle.met(0, "vertex " + std::to_string(v) + " has valence " +
                          std::to_string(around.back().size()) + ", not 4");
      return found;
    }
  }
  for (std::size_t first = 0; first < 4; ++first) {
    const auto label = doo_sabin_labels(around, fine, first, obstacle);
    if (!label) continue;
    if (auto result = doo_sabin_mesh(around, fine, *label, obstacle))
      found.push_back(std::move(*result));
  }
  return found;
}

}  // namespace arete::recovery
