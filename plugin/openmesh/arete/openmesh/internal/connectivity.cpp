// SPDX-License-Identifier: MIT
#include "arete/openmesh/internal/connectivity.h"

#include <algorithm>

#include "arete/openmesh/internal/edge_store.h"
#include "arete/openmesh/internal/large_pages.h"
#include "arete/parallel/for_each_band.h"

namespace arete::openmesh::detail {
namespace {

using OpenMesh::ArrayKernel;
using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

constexpr Index band_rows = 64;

// Writes one patch in the frame in which faces run (r, b), (r, b+1), (r+1, b+1), (r+1, b): the
// patch's own columns, or in a mirrored patch the columns from the other end.
//
// Half-edges of that frame: east/west along a row, north towards the next row, south back. East
// belongs to the cell on its side of the next row, north to the cell west of it.
class PatchWriter {
 public:
  PatchWriter(ArrayKernel& mesh, const RefinedPatch& patch)
      : mesh_(mesh),
        edges_(mesh),
        patch_(patch),
        rows_(patch.rows.fine()),
        cols_(patch.cols.fine()),
        cell_rows_(patch.rows.fine_cells()),
        cell_cols_(patch.cols.fine_cells()),
        mirrored_(patch.coarse.mirrored),
        wraps_rows_(patch.rows.wraps),
        wraps_cols_(patch.cols.wraps) {}

  /// Rows can be written in any order, also at the same time; the rim comes last.
  void write_rows(Index first, Index count) {
    std::vector<int> vertices(static_cast<std::size_t>(cols_));
    std::vector<int> next_vertices(vertices.size());
    read_vertices(first, vertices);
    for (Index r = first; r < first + count; ++r) {
      if (r + 1 < rows_ || wraps_rows_) read_vertices(row_after(r), next_vertices);
      if (patch_.triangles()) {
        write_edges(r, vertices, next_vertices);
        if (r < cell_rows_) write_cells(r, vertices, next_vertices);
      } else {
        write_quad_row(r, vertices, next_vertices);
      }
      write_vertices(r, vertices);
      vertices.swap(next_vertices);
    }
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
  [[nodiscard]] Index row_before(Index r) const { return r > 0 ? r - 1 : rows_ - 1; }
  [[nodiscard]] Index after(Index b) const { return b + 1 < cols_ ? b + 1 : 0; }
  [[nodiscard]] Index before(Index b) const { return b > 0 ? b - 1 : cols_ - 1; }

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

  // The edges along row r and those from it to the next row, each once and whole.
  void write_quad_row(Index r, const std::vector<int>& vertices, const std::vector<int>& next) {
    const bool over = r < cell_rows_;
    const bool under = wraps_rows_ || r > 0;
    for (Index b = 0; b < cell_cols_; ++b) {
      // Between the ends everything is a fixed step on.
      if (b == 1 && over && under && cell_cols_ > 3) b = write_between(r, vertices, next);
      write_along(r, b, over, under, vertices);
    }
    if (!over) return;
    for (Index c = 0; c < cell_cols_; ++c)
      mesh_.set_halfedge_handle(FaceHandle(patch_.face(r, c)),
                                HalfedgeHandle(2 * patch_.edge_along_row(r, c)));
    for (Index b = 0; b < cols_; ++b) {
      if (b == 1 && under && cell_cols_ > 3) b = first_at_the_end();
      write_to_next(r, b, vertices, next);
    }
  }

  void write_along(Index r, Index b, bool over, bool under, const std::vector<int>& vertices) {
    HalfEdgeFields to_east{-1, vertex(vertices, after(b)).idx(), -1, -1};
    HalfEdgeFields to_west{-1, vertex(vertices, b).idx(), -1, -1};
    if (over) {
      to_east.face = patch_.face(r, cell(b));
      to_east.next = north(r, after(b)).idx();
      to_east.prev = south(r, b).idx();
    }
    if (under) {
      const Index below = row_before(r);
      to_west.face = patch_.face(below, cell(b));
      to_west.next = south(below, b).idx();
      to_west.prev = north(below, after(b)).idx();
    }
    edges_.write(east(r, b).idx() / 2, to_east, to_west);
  }

  void write_to_next(Index r, Index b, const std::vector<int>& vertices,
                     const std::vector<int>& next) {
    HalfEdgeFields to_north{-1, vertex(next, b).idx(), -1, -1};
    HalfEdgeFields to_south{-1, vertex(vertices, b).idx(), -1, -1};
    if (wraps_cols_ || b > 0) {
      to_north.face = patch_.face(r, cell(before(b)));
      to_north.next = west(row_after(r), before(b)).idx();
      to_north.prev = east(r, before(b)).idx();
    }
    if (wraps_cols_ || b < cols_ - 1) {
      to_south.face = patch_.face(r, cell(b));
      to_south.next = east(r, b).idx();
      to_south.prev = west(row_after(r), b).idx();
    }
    edges_.write(north(r, b).idx() / 2, to_north, to_south);
  }

  // Where what write_between() leaves begins again: the last cell and column.
  [[nodiscard]] Index first_at_the_end() const { return cols_ - 2; }

  // write_along() and write_to_next() for b = 1 .. first_at_the_end() - 1, where numbers grow by a
  // step. \pre there are cells over and under the row.
  Index write_between(Index r, const std::vector<int>& vertices, const std::vector<int>& next) {
    const int step = mirrored_ ? -1 : 1;
    const Index below = row_before(r);
    const int along = east(r, 1).idx() / 2;
    const int along_next = east(row_after(r), 1).idx() / 2;
    const int up = north(r, 1).idx() / 2;
    const int up_below = north(below, 1).idx() / 2;
    const int face = patch_.face(r, cell(1));
    const int face_below = patch_.face(below, cell(1));
    const int count = static_cast<int>(first_at_the_end()) - 1;
    const int* const v = vertices.data() + 1;
    const int* const w = next.data() + 1;
    for (int i = 0; i < count; ++i) {
      const int k = i * step;
      edges_.write(along + k, {face + k, v[i + 1], 2 * (up + k + step), 2 * (up + k) + 1},
                   {face_below + k, v[i], 2 * (up_below + k) + 1, 2 * (up_below + k + step)});
    }
    for (int i = 0; i < count; ++i) {
      const int k = i * step;
      edges_.write(up + k,
                   {face + k - step, w[i], 2 * (along_next + k - step) + 1, 2 * (along + k - step)},
                   {face + k, v[i], 2 * (along + k), 2 * (along_next + k) + 1});
    }
    return first_at_the_end();
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

  [[nodiscard]] static VertexHandle vertex(const std::vector<int>& vertices, Index b) {
    return VertexHandle(vertices[static_cast<std::size_t>(b)]);
  }

  ArrayKernel& mesh_;
  EdgeStore edges_;
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

void build_connectivity(ArrayKernel& mesh, const Rebuild& rebuild, int threads) {
  const auto vertices = static_cast<std::size_t>(rebuild.vertices);
  const auto edges = static_cast<std::size_t>(rebuild.edges);
  const auto faces = static_cast<std::size_t>(rebuild.faces);
  reserve_in_large_pages(mesh, vertices, edges, faces);
  mesh.resize(vertices, edges, faces);
  // The setters for quads reach into the rows of others.
  if (!EdgeStore::direct_is_right()) threads = 1;
  for (const RefinedPatch& patch : rebuild.patches) {
    PatchWriter writer(mesh, patch);
    for_each_band(patch.rows.fine(), band_rows, threads,
                  [&](Index first, Index count) { writer.write_rows(first, count); });
    writer.write_rim();
  }
  for (const auto& [old_number, new_number] : rebuild.lone_vertices)
    mesh.set_isolated(VertexHandle(new_number));
}

}  // namespace arete::openmesh::detail
