// SPDX-License-Identifier: MIT
#pragma once

#include <OpenMesh/Core/Mesh/ArrayKernel.hh>
#include <cstddef>
#include <cstring>
#include <type_traits>

namespace arete::openmesh::detail {

/// All that OpenMesh keeps of a half-edge, -1 for none.
struct HalfEdgeFields {
  int face = -1;
  int vertex = -1;  ///< where it ends
  int next = -1;
  int prev = -1;
};

/// Writes edges whole, one after the other. OpenMesh's own setters reach every half-edge from three
/// places of the mesh, which takes twice as long; so where its records are laid out like
/// HalfEdgeFields (OpenMesh itself is asked, see direct_is_right()) they are filled directly. To be
/// made anew when the number of edges has changed.
class EdgeStore {
 public:
  explicit EdgeStore(OpenMesh::ArrayKernel& mesh, bool direct = direct_is_right())
      : mesh_(mesh),
        records_(direct && mesh.n_edges() > 0
                     ? reinterpret_cast<std::byte*>(&mesh.edge(OpenMesh::EdgeHandle(0)))
                     : nullptr) {}

  /// Half-edges 2 edge and 2 edge + 1. A next or prev of -1 is left to be set later.
  void write(int edge, const HalfEdgeFields& even, const HalfEdgeFields& odd) {
    if (records_) {
      std::byte* const record =
          records_ + sizeof(HalfEdgeFields) * 2 * static_cast<std::size_t>(edge);
      // Number by number: a copy of the whole would have to wait until it is put together.
      fill(record, even);
      fill(record + sizeof(HalfEdgeFields), odd);
    } else {
      set(2 * edge, even);
      set(2 * edge + 1, odd);
    }
  }

  /// Whether this build of OpenMesh lays its records out as assumed.
  [[nodiscard]] static bool direct_is_right() {
    using Edge = OpenMesh::ArrayItems::Edge;
    if constexpr (sizeof(Edge) != 2 * sizeof(HalfEdgeFields) ||
                  !std::is_trivially_copyable_v<Edge>) {
      return false;
    } else {
      static const bool right = [] {
        OpenMesh::ArrayKernel probe;
        probe.new_edge(OpenMesh::VertexHandle(0), OpenMesh::VertexHandle(0));
        EdgeStore through_setters(probe, false);
        const HalfEdgeFields expected[2]{{1, 2, 1, 1}, {5, 6, 0, 0}};
        through_setters.write(0, expected[0], expected[1]);
        return std::memcmp(&probe.edge(OpenMesh::EdgeHandle(0)), expected, sizeof expected) == 0;
      }();
      return right;
    }
  }

 private:
  static void fill(std::byte* record, const HalfEdgeFields& fields) {
    std::memcpy(record, &fields.face, sizeof(int));
    std::memcpy(record + sizeof(int), &fields.vertex, sizeof(int));
    std::memcpy(record + 2 * sizeof(int), &fields.next, sizeof(int));
    std::memcpy(record + 3 * sizeof(int), &fields.prev, sizeof(int));
  }
  void set(int h, const HalfEdgeFields& fields) {
    using OpenMesh::HalfedgeHandle;
    const HalfedgeHandle handle(h);
    mesh_.set_vertex_handle(handle, OpenMesh::VertexHandle(fields.vertex));
    mesh_.set_face_handle(handle, OpenMesh::FaceHandle(fields.face));
    if (fields.next >= 0) mesh_.set_next_halfedge_handle(handle, HalfedgeHandle(fields.next));
    if (fields.prev >= 0) mesh_.set_prev_halfedge_handle(handle, HalfedgeHandle(fields.prev));
  }

  OpenMesh::ArrayKernel& mesh_;
  std::byte* records_;  ///< nullptr: through the setters
};

}  // namespace arete::openmesh::detail
