// SPDX-License-Identifier: MIT
// A quad and one of its half-edges, called its bottom, is a frame: it fixes right, up, left, down,
// and carries over to the neighbours. Rows and columns are the orbits of those moves.
#include <algorithm>
#include <string>

#include "arete/topology/not_a_grid.h"
#include "arete/field/at.h"
#include "arete/topology/recover_part.h"

namespace arete::detail {
namespace {

// Moves from frame to frame; -1 beyond the rim.
int right_of(const HalfEdges& mesh, int bottom) {
  const int left = mesh.twin(mesh.next(bottom));
  return left < 0 ? -1 : mesh.next(left);
}
int left_of(const HalfEdges& mesh, int bottom) {
  const int right = mesh.twin(mesh.previous(bottom));
  return right < 0 ? -1 : mesh.previous(right);
}
int above(const HalfEdges& mesh, int bottom) { return mesh.twin(mesh.next(mesh.next(bottom))); }
int below(const HalfEdges& mesh, int bottom) {
  const int top = mesh.twin(bottom);
  return top < 0 ? -1 : mesh.next(mesh.next(top));
}

using Move = int (*)(const HalfEdges&, int);

// The last frame before the rim, or `start` again when there is none.
int walk_to_end(const HalfEdges& mesh, int start, Move move) {
  int frame = start;
  for (int to = move(mesh, frame); to >= 0 && to != start; to = move(mesh, frame)) frame = to;
  return move(mesh, frame) < 0 ? frame : start;
}

struct Walk {
  std::vector<int> frames;
  bool wraps = false;
};

Walk walk(const HalfEdges& mesh, int start, Move move) {
  Walk walk{{start}, false};
  for (int to = move(mesh, start); to >= 0; to = move(mesh, to)) {
    if (to == start) {
      walk.wraps = true;
      break;
    }
    walk.frames.push_back(to);
  }
  return walk;
}

// Inside 4 quads meet, at the rim 2, at a corner 1.
void check_valences(const HalfEdges& mesh, std::span<const int> component) {
  int offender = -1;
  for (int f : component)
    for (int v : mesh.faces()[f])
      if ((mesh.rim_from(v) >= 0 ? mesh.valence(v) > 2 : mesh.valence(v) != 4) &&
          (offender < 0 || v < offender))
        offender = v;
  if (offender < 0) return;
  const std::string faces = std::to_string(mesh.valence(offender)) + " faces";
  if (mesh.rim_from(offender) >= 0)
    throw NotAGrid::at_vertex(offender, "on the rim has " + faces +
                                            " where a grid has 1 or 2: a hole or a notch; fill it");
  throw NotAGrid::at_vertex(offender, "has " + faces +
                                          " where a grid has 4: an extraordinary vertex, which "
                                          "grid refinement cannot treat");
}

NotAGrid irregular(const HalfEdges& mesh, int frame) {
  return NotAGrid::at_face(mesh.face(frame), "breaks the rows and columns of its neighbours");
}

}  // namespace

GridPatch recover_quads(const HalfEdges& mesh, std::span<const int> component, Marks& marks) {
  check_valences(mesh, component);
  const int seed = mesh.faces().starts[at(component.front())];
  const int start = walk_to_end(mesh, walk_to_end(mesh, seed, left_of), below);
  const Walk column = walk(mesh, start, above);
  const Walk bottom = walk(mesh, start, right_of);
  const Index rows = static_cast<Index>(column.frames.size());
  const Index cols = static_cast<Index>(bottom.frames.size());
  if (rows * cols != static_cast<Index>(component.size())) {
    if (bottom.wraps && column.wraps)
      throw NotAGrid::at_face(mesh.face(start),
                              "lies on a closed surface whose columns close with an offset; cut it "
                              "open along a row and a column");
    throw irregular(mesh, start);
  }

  std::vector<int> frames;
  frames.reserve(component.size());
  marks.clear();
  for (int first : column.frames) {
    const Walk row = walk(mesh, first, right_of);
    if (row.wraps != bottom.wraps || row.frames.size() != bottom.frames.size())
      throw irregular(mesh, first);
    for (int frame : row.frames)
      if (!marks.mark_face(mesh.face(frame))) throw irregular(mesh, frame);
    frames.insert(frames.end(), row.frames.begin(), row.frames.end());
  }
  for (Index r = 0; r < rows; ++r) {
    for (Index c = 0; c < cols; ++c) {
      const int over = above(mesh, frames[at(r * cols + c)]);
      const int expected = r + 1 < rows   ? frames[at((r + 1) * cols + c)]
                           : column.wraps ? frames[at(c)]
                                          : -1;
      if (over != expected) throw irregular(mesh, frames[at(r * cols + c)]);
    }
  }

  GridPatch patch;
  patch.wraps_rows = column.wraps;
  patch.wraps_cols = bottom.wraps;
  patch.extent = {rows + (column.wraps ? 0 : 1), cols + (bottom.wraps ? 0 : 1)};
  patch.vertices.reserve(at(patch.extent.rows * patch.extent.cols));
  for (Index r = 0; r < patch.extent.rows; ++r) {
    for (Index c = 0; c < patch.extent.cols; ++c) {
      // Beyond the last cell the corner on its other side.
      int h = frames[at(std::min(r, rows - 1) * cols + std::min(c, cols - 1))];
      if (r == rows && c == cols)
        h = mesh.next(mesh.next(h));
      else if (r == rows)
        h = mesh.previous(h);
      else if (c == cols)
        h = mesh.next(h);
      patch.vertices.push_back(mesh.from(h));
    }
  }
  patch.cells.reserve(frames.size());
  for (int frame : frames) patch.cells.push_back({{mesh.face(frame), -1}, Diagonal::none});
  return patch;
}

}  // namespace arete::detail
