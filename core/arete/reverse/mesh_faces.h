// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "arete/field/grid.h"
#include "arete/topology/face_list.h"

namespace arete {

/// The connectivity of a polygon mesh on plain indices: every face lists its vertices 0..vertices-1
/// in order, all faces turned the same way where they meet.
struct MeshFaces {
  Index vertices = 0;
  std::vector<std::vector<Index>> faces;

  [[nodiscard]] friend bool operator==(const MeshFaces&, const MeshFaces&) = default;
};

/// The same faces in the other form.
[[nodiscard]] MeshFaces mesh_faces(Index vertices, const FaceList& faces);
[[nodiscard]] FaceList face_list(const MeshFaces& mesh);

/// The edges of a mesh and what meets at vertices: what the rules of subdivision and their reverses
/// ask for.
class MeshNeighbours {
 public:
  using Edge = std::array<Index, 2>;  ///< the smaller vertex first

  /// \throws InvalidField for an index out of range, a face of fewer than three vertices or with a
  /// vertex twice, an edge of more than two faces or run through twice the same way, a vertex that
  /// is in no face or whose faces do not form one fan; the message names the face or vertex.
  explicit MeshNeighbours(const MeshFaces& mesh);

  [[nodiscard]] Index edge_count() const { return static_cast<Index>(edges_.size()); }
  /// Sorted by (smaller, larger) vertex.
  [[nodiscard]] const std::vector<Edge>& edges() const { return edges_; }
  /// \pre the two are neighbours
  [[nodiscard]] Index edge(Index a, Index b) const {
    const auto& around = vertex_edges(a);
    return *std::find_if(around.begin(), around.end(),
                         [&](Index e) { return other_end(e, a) == b; });
  }
  /// One face, or two inside.
  [[nodiscard]] const std::vector<Index>& edge_faces(Index edge) const {
    return edge_faces_[static_cast<std::size_t>(edge)];
  }
  [[nodiscard]] const std::vector<Index>& vertex_edges(Index v) const {
    return vertex_edges_[static_cast<std::size_t>(v)];
  }
  [[nodiscard]] const std::vector<Index>& vertex_faces(Index v) const {
    return vertex_faces_[static_cast<std::size_t>(v)];
  }
  [[nodiscard]] Index other_end(Index edge, Index v) const {
    const Edge& e = edges_[static_cast<std::size_t>(edge)];
    return e[0] == v ? e[1] : e[0];
  }
  [[nodiscard]] bool on_boundary(Index v) const {
    return vertex_faces(v).size() != vertex_edges(v).size();
  }
  [[nodiscard]] bool boundary_edge(Index edge) const { return edge_faces(edge).size() == 1; }

 private:
  void check_fans(const MeshFaces& mesh) const;

  std::vector<Edge> edges_;
  std::vector<std::vector<Index>> edge_faces_;
  std::vector<std::vector<Index>> vertex_edges_;
  std::vector<std::vector<Index>> vertex_faces_;
};

/// The faces of each connected part, by number.
[[nodiscard]] std::vector<std::vector<Index>> connected_faces(const MeshFaces& mesh);

}  // namespace arete
