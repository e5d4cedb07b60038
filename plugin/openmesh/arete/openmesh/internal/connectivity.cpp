// SPDX-License-Identifier: MIT
#include "arete/openmesh/internal/connectivity.h"

#include <algorithm>

namespace arete::openmesh::detail {
namespace {

using OpenMesh::ArrayKernel;
using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

// Writes one patch in the frame in which faces run (r, b), (r, b+1), (r+1, b+1), (r+1, b): the
// patch's own columns, or in a mirrored patch the columns from the other end.
//
// Half-edges of that frame: east/west along a row, north towards the next row, south back. East
// belongs to the cell on its side of the next row, north to the cell west of it.
class PatchWriter {
 public:
  PatchWriter(ArrayKernel& mesh, const RefinedPatch& patch)
      : mesh_(mesh),
        patch_(patch),
        rows_(patch.rows.fine()),
        cols_(patch.cols.fine()),
        cell_rows_(patch.rows.fine_cells()),
        cell_cols_(patch.cols.fine_cells()),
        mirrored_(patch.coarse.mirrored),
        wraps_rows_(patch.rows.wraps),
        wraps_cols_(patch.cols.wraps) {}

  void write() {
    std::vector<int> vertices(static_cast<std::size_t>(cols_));
    std::vector<int> next_vertices(vertices.size());
    std::vector<int> first_vertices;
    read_vertices(0, vertices);
    first_vertices = vertices;
    for (Index r = 0; r < rows_; ++r) {
      if (r + 1 < rows_)
        read_vertices(r + 1, next_vertices);
      else if (wraps_rows_)
        next_vertices = first_vertices;
      write_edges(r, vertices, next_vertices);
      if (r < cell_rows_) write_cells(r, vertices, next_vertices);
      write_vertices(r, vertices);
      vertices.swap(next_vertices);
    }
    write_rim();
  }

 private:
  void read_vertices(Index r, std::vector<int>& vertices) const {
    patch_.row_vertices(r, vertices);
    if (mirrored_) std::reverse(vertices.begin(), vertices.end());
  }
  [[nodiscard]] Index column(Index b) const { return mirrored_ ? cols_ - 1 - b : b; }
  [[nodiscard]] Index cell(Index b) const {
    if (!mirrored_) return b;
    return wraps_cols_ ? (2 * cols_ - 2 - b) % cols_ : cell_cols_ - 1 - b;
  }
  [[nodiscard]] Index row_after(Index r) const { return r + 1 < rows_ ? r + 1 : 0; }
  [[nodiscard]] Index after(Index b) const { return b + 1 < cols_ ? b + 1 : 0; }

  [[nodiscard]] HalfedgeHandle east(Index r, Index b) const {
    return HalfedgeHandle(2 * patch_.edge_along_row(r, cell(b)));
  }
  [[nodiscard]] HalfedgeHandle west(Index r, Index b) const {
    return HalfedgeHandle(2 * patch_.edge_along_row(r, cell(b)) + 1);
  }
  [[nodiscard]] HalfedgeHandle north(Index r, Index b) const {
    return HalfedgeHandle(2 * patch_.edge_to_next_row(r, column(b)));
  }
  [[nodiscard]] HalfedgeHandle south(Index r, Index b) const {
    return HalfedgeHandle(2 * patch_.edge_to_next_row(r, column(b)) + 1);
  }

  void write_edges(Index r, const std::vector<int>& vertices, const std::vector<int>& next) {
    for (Index b = 0; b < cell_cols_; ++b) {
      mesh_.set_vertex_handle(east(r, b), vertex(vertices, after(b)));
      mesh_.set_vertex_handle(west(r, b), vertex(vertices, b));
    }
    if (r == cell_rows_) return;
    for (Index b = 0; b < cols_; ++b) {
      mesh_.set_vertex_handle(north(r, b), vertex(next, b));
      mesh_.set_vertex_handle(south(r, b), vertex(vertices, b));
    }
  }

  void write_cells(Index r, const std::vector<int>& vertices, const std::vector<int>& next) {
    for (Index b = 0; b < cell_cols_; ++b) {
      const HalfedgeHandle bottom = east(r, b);
      const HalfedgeHandle right = north(r, after(b));
      const HalfedgeHandle top = west(row_after(r), b);
      const HalfedgeHandle left = south(r, b);
      const FaceHandle face(patch_.face(r, cell(b)));
      if (!patch_.triangles()) {
        write_face(face, {bottom, right, top, left});
        continue;
      }
      const FaceHandle other(face.idx() + 1);
      const int edge = patch_.diagonal(r, cell(b));
      const HalfedgeHandle back(2 * edge);
      const HalfedgeHandle forth(2 * edge + 1);
      if ((patch_.parent(r, cell(b)).diagonal == Diagonal::main) != mirrored_) {
        mesh_.set_vertex_handle(back, vertex(vertices, b));
        mesh_.set_vertex_handle(forth, vertex(next, after(b)));
        write_face(face, {bottom, right, back});
        write_face(other, {forth, top, left});
      } else {
        mesh_.set_vertex_handle(back, vertex(next, b));
        mesh_.set_vertex_handle(forth, vertex(vertices, after(b)));
        write_face(face, {bottom, back, left});
        write_face(other, {forth, right, top});
      }
    }
  }

  template <std::size_t N>
  void write_face(FaceHandle face, const HalfedgeHandle (&loop)[N]) {
    for (std::size_t i = 0; i < N; ++i) {
      mesh_.set_face_handle(loop[i], face);
      mesh_.set_next_halfedge_handle(loop[i], loop[(i + 1) % N]);
    }
    mesh_.set_halfedge_handle(face, loop[0]);
  }

  // A vertex on the rim must refer to the half-edge that leaves it along the rim.
  void write_vertices(Index r, const std::vector<int>& vertices) {
    for (Index b = 0; b < cell_cols_; ++b)
      mesh_.set_halfedge_handle(vertex(vertices, b), east(r, b));
    if (!wraps_rows_ && r == 0) {
      for (Index b = 1; b < cols_; ++b)
        mesh_.set_halfedge_handle(vertex(vertices, b), west(r, b - 1));
      if (wraps_cols_) mesh_.set_halfedge_handle(vertex(vertices, 0), west(r, cols_ - 1));
    }
    if (wraps_cols_) return;
    if (r < cell_rows_) mesh_.set_halfedge_handle(vertex(vertices, 0), north(r, 0));
    if (r > 0 || wraps_rows_)
      mesh_.set_halfedge_handle(vertex(vertices, cols_ - 1),
                                south(r > 0 ? r - 1 : cell_rows_ - 1, cols_ - 1));
  }

  // The loop of half-edges without a face, or the two loops of a tube.
  void write_rim() {
    const Index last_row = rows_ - 1;
    const Index last_col = cols_ - 1;
    const auto rim = [&](HalfedgeHandle from, HalfedgeHandle to) {
      mesh_.set_boundary(from);
      mesh_.set_next_halfedge_handle(from, to);
    };
    if (!wraps_rows_) {
      for (Index b = 0; b < cell_cols_; ++b) {
        rim(west(0, b), b > 0         ? west(0, b - 1)
                        : wraps_cols_ ? west(0, cell_cols_ - 1)
                                      : north(0, 0));
        rim(east(last_row, b), b + 1 < cell_cols_ ? east(last_row, b + 1)
                               : wraps_cols_      ? east(last_row, 0)
                                                  : south(cell_rows_ - 1, last_col));
      }
    }
    if (!wraps_cols_) {
      for (Index r = 0; r < cell_rows_; ++r) {
        rim(north(r, 0), r + 1 < cell_rows_ ? north(r + 1, 0)
                         : wraps_rows_      ? north(0, 0)
                                            : east(last_row, 0));
        rim(south(r, last_col), r > 0         ? south(r - 1, last_col)
                                : wraps_rows_ ? south(cell_rows_ - 1, last_col)
                                              : west(0, cell_cols_ - 1));
      }
    }
  }

  [[nodiscard]] static VertexHandle vertex(const std::vector<int>& vertices, Index b) {
    return VertexHandle(vertices[static_cast<std::size_t>(b)]);
  }

  ArrayKernel& mesh_;
  const RefinedPatch& patch_;
  Index rows_;
  Index cols_;
  Index cell_rows_;
  Index cell_cols_;
  bool mirrored_;
  bool wraps_rows_;
  bool wraps_cols_;
};

}  // namespace

void build_connectivity(ArrayKernel& mesh, const Rebuild& rebuild) {
  mesh.resize(static_cast<std::size_t>(rebuild.vertices), static_cast<std::size_t>(rebuild.edges),
              static_cast<std::size_t>(rebuild.faces));
  for (const RefinedPatch& patch : rebuild.patches) PatchWriter(mesh, patch).write();
  for (const auto& [old_number, new_number] : rebuild.lone_vertices)
    mesh.set_isolated(VertexHandle(new_number));
}

}  // namespace arete::openmesh::detail
