// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "arete/topology/grid_patch.h"
#include "arete/topology/half_edges.h"

namespace arete::detail {

/// Reusable "already seen" flags, so that many small parts cost no more than a large one: a face or
/// vertex is marked when its entry equals the current stamp.
struct Marks {
  Marks(int face_count, int vertex_count)
      : faces(static_cast<std::size_t>(face_count), 0),
        vertices(static_cast<std::size_t>(vertex_count), 0) {}
  void clear() { ++stamp; }
  /// Marks it; false if it was marked before.
  bool mark_face(int face) { return mark(faces[static_cast<std::size_t>(face)]); }
  bool mark_vertex(int vertex) { return mark(vertices[static_cast<std::size_t>(vertex)]); }

  std::vector<int> faces;
  std::vector<int> vertices;
  int stamp = 0;

 private:
  [[nodiscard]] bool mark(int& entry) const {
    if (entry == stamp) return false;
    entry = stamp;
    return true;
  }
};

/// The open grid of quads whose vertices and faces are numbered row by row, as programs that make
/// terrain meshes number them; nothing for any other mesh. Only looks whether it is so, which is
/// many times faster than finding rows and columns.
[[nodiscard]] std::optional<GridPatch> recover_in_order(const FaceList& faces, int vertex_count);

/// The two halves of recover_grids(): one connected component of quads, or of triangles, whose
/// faces are given in ascending order. \throws NotAGrid.
[[nodiscard]] GridPatch recover_quads(const HalfEdges& mesh, std::span<const int> component,
                                      Marks& marks);
[[nodiscard]] GridPatch recover_triangles(const HalfEdges& mesh, std::span<const int> component,
                                          Marks& marks, std::span<const Point3> positions);

}  // namespace arete::detail
