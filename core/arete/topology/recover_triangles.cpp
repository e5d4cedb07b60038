// SPDX-License-Identifier: MIT
// The rim of an open W x H grid has 2 (W + H) - 4 vertices, so the number of vertices and the
// length of the rim give W and H. From a corner the rim also gives the bottom row and the left
// column; then every cell is determined: the triangle on its bottom edge ends either at the known
// top left vertex or at the unknown top right one.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "arete/topology/not_a_grid.h"
#include "arete/field/at.h"
#include "arete/topology/recover_part.h"

namespace arete::detail {
namespace {

class Sweep {
 public:
  Sweep(const HalfEdges& mesh, std::span<const int> component, Marks& marks)
      : mesh_(mesh), component_(component), marks_(marks) {
    count_vertices();
    trace_rim();
    solve_sizes();
  }

  [[nodiscard]] Index rim_length() const { return static_cast<Index>(rim_.size()); }
  [[nodiscard]] int rim_vertex(Index i) const { return mesh_.from(rim_[wrapped(i)]); }
  [[nodiscard]] Extent extent() const { return {short_, long_}; }

  // Tries the grid whose first row starts at rim vertex `corner`; patch() is it if true.
  bool from_corner(Index corner, Extent extent) {
    marks_.clear();
    patch_.extent = extent;
    patch_.vertices.resize(at(extent.rows * extent.cols));
    patch_.cells.clear();
    bottoms_.clear();
    for (Index c = 0; c + 1 < extent.cols; ++c) bottoms_.push_back(rim_[wrapped(corner + c)]);
    for (Index c = 0; c < extent.cols; ++c) patch_.vertices[at(c)] = rim_vertex(corner + c);
    for (Index r = 0; r + 1 < extent.rows; ++r) {
      patch_.vertices[at((r + 1) * extent.cols)] = rim_vertex(corner - r - 1);
      if (!sweep_row(r)) return false;
    }
    return std::all_of(bottoms_.begin(), bottoms_.end(), [](int bottom) { return bottom < 0; });
  }
  [[nodiscard]] GridPatch& patch() { return patch_; }

 private:
  [[nodiscard]] std::size_t wrapped(Index i) const {
    const Index n = rim_length();
    return at(((i % n) + n) % n);
  }

  void count_vertices() {
    marks_.clear();
    for (int f : component_)
      for (int v : mesh_.faces()[f])
        if (marks_.mark_vertex(v)) ++vertices_;
  }

  void trace_rim() {
    int first = -1;
    Index length = 0;
    for (int f : component_) {
      for (int v : mesh_.faces()[f]) {
        const int h = mesh_.rim_from(v);
        if (h < 0 || mesh_.face(h) != f) continue;
        if (first < 0) first = h;
        ++length;
      }
    }
    if (first < 0)
      throw NotAGrid::at_face(component_.front(),
                              "lies on a closed surface of triangles; cut it open, or give quads");
    marks_.clear();
    int h = first;
    do {
      rim_.push_back(h);
      marks_.mark_vertex(mesh_.from(h));
      h = mesh_.rim_from(mesh_.to(h));
    } while (h != first);
    if (rim_length() == length) return;
    for (int f : component_)
      for (int v : mesh_.faces()[f])
        if (mesh_.rim_from(v) >= 0 && marks_.mark_vertex(v))
          throw NotAGrid::at_vertex(
              v,
              "lies on a second rim: a hole, or a tube of triangles; fill the hole, or give the "
              "tube as quads");
  }

  void solve_sizes() {
    const Index sum = rim_length() / 2 + 2;
    const double root = std::sqrt(static_cast<double>(sum * sum - 4 * vertices_));
    const auto size =
        std::isnan(root) ? Index{0} : (sum - static_cast<Index>(std::llround(root))) / 2;
    if (rim_length() % 2 != 0 || size < 2 || size * (sum - size) != vertices_ ||
        2 * (size - 1) * (sum - size - 1) != static_cast<Index>(component_.size()))
      throw NotAGrid::at_face(component_.front(),
                              "belongs to " + std::to_string(component_.size()) +
                                  " triangles with " + std::to_string(vertices_) + " vertices, " +
                                  std::to_string(rim_length()) +
                                  " of them on the rim, which no grid has");
    short_ = size;
    long_ = sum - size;
  }

  // Takes the triangle of half-edge h, which belongs to one cell only.
  bool take(int h) { return marks_.mark_face(mesh_.face(h)); }

  // Row r of cells over bottoms_; afterwards they are those of the next row.
  bool sweep_row(Index r) {
    const Index cols = patch_.extent.cols;
    int right = -1;  // right edge of the cell before, upwards; -1 is the rim
    for (Index c = 0; c + 1 < cols; ++c) {
      const int bottom = bottoms_[at(c)];
      if (bottom < 0 || !take(bottom)) return false;
      const int top_left = patch_.vertices[at((r + 1) * cols + c)];
      const int apex_edge = mesh_.next(bottom);  // from (r, c+1) to the apex
      const bool anti = mesh_.to(apex_edge) == top_left;
      // The diagonal, seen from the other triangle.
      const int mate = mesh_.twin(anti ? apex_edge : mesh_.next(apex_edge));
      if (mate < 0 || !take(mate)) return false;
      // anti: the mate is (top left, (r, c+1), top right); main: ((r, c), top right, top left).
      const int left = anti ? mesh_.previous(bottom) : mesh_.previous(mate);
      const int top = anti ? mesh_.previous(mate) : mesh_.next(mate);
      const int new_right = anti ? mesh_.next(mate) : apex_edge;
      if (mesh_.to(top) != top_left) return false;
      if (c == 0 ? mesh_.twin(left) >= 0 : mesh_.twin(left) != right) return false;
      right = new_right;
      patch_.vertices[at((r + 1) * cols + c + 1)] = mesh_.from(top);
      patch_.cells.push_back(
          {{mesh_.face(bottom), mesh_.face(mate)}, anti ? Diagonal::anti : Diagonal::main});
      bottoms_[at(c)] = mesh_.twin(top);
    }
    return mesh_.twin(right) < 0;
  }

  const HalfEdges& mesh_;
  std::span<const int> component_;
  Marks& marks_;
  Index vertices_ = 0;
  std::vector<int> rim_;
  std::vector<int> bottoms_;
  GridPatch patch_;
  Index short_ = 0;
  Index long_ = 0;
};

double edge_length(const GridPatch& patch, std::span<const Point3> positions) {
  double sum = 0;
  const auto add = [&](int a, int b) {
    double squared = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double d = positions[at(a)][k] - positions[at(b)][k];
      squared += d * d;
    }
    sum += std::sqrt(squared);
  };
  for (Index r = 0; r < patch.extent.rows; ++r) {
    for (Index c = 0; c < patch.extent.cols; ++c) {
      if (c + 1 < patch.extent.cols) add(patch.vertex(r, c), patch.vertex(r, c + 1));
      if (r + 1 < patch.extent.rows) add(patch.vertex(r, c), patch.vertex(r + 1, c));
    }
  }
  return sum;
}

}  // namespace

GridPatch recover_triangles(const HalfEdges& mesh, std::span<const int> component, Marks& marks,
                            std::span<const Point3> positions) {
  Sweep sweep(mesh, component, marks);
  const Extent lying = sweep.extent();
  std::vector<Extent> extents{lying};
  if (lying.rows != lying.cols) extents.push_back({lying.cols, lying.rows});
  for (Index i = 0; i < sweep.rim_length(); ++i) {
    if (mesh.valence(sweep.rim_vertex(i)) != 1) continue;
    for (Extent extent : extents)
      if (sweep.from_corner(i, extent)) return std::move(sweep.patch());
  }
  std::optional<GridPatch> best;
  double best_length = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < sweep.rim_length(); ++i) {
    if (mesh.valence(sweep.rim_vertex(i)) != 2) continue;
    for (Extent extent : extents) {
      if (!sweep.from_corner(i, extent)) continue;
      if (positions.empty()) return std::move(sweep.patch());
      const double length = edge_length(sweep.patch(), positions);
      if (best && length >= best_length) continue;
      best = sweep.patch();
      best_length = length;
    }
  }
  if (best) return std::move(*best);
  throw NotAGrid::at_face(
      component.front(), "belongs to triangles that cannot be paired into the cells of a grid of " +
                             std::to_string(lying.rows) + " x " + std::to_string(lying.cols) +
                             " vertices");
}

}  // namespace arete::detail
