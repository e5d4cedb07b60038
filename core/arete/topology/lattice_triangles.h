// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "arete/field/grid.h"

namespace arete {

/// A Delaunay triangulation of some samples of a grid, grown sample by sample (Guibas and Stolfi
/// 1985; Lawson 1977): it covers the whole grid from the beginning, with two triangles between the
/// four corner samples. Which side of an edge a sample lies on is decided in integers, so that no
/// triangle is ever flat or turned over, whatever the samples and their order.
class LatticeTriangles {
 public:
  /// x along the columns, y along the rows.
  struct Corner {
    Index x = 0;
    Index y = 0;
    [[nodiscard]] friend bool operator==(const Corner&, const Corner&) = default;
  };
  /// Corners as numbers of vertices, turning from x to y. across[k] is the triangle beyond the edge
  /// opposite corner k, or -1.
  struct Triangle {
    std::array<int, 3> corners{};
    std::array<int, 3> across{-1, -1, -1};
    /// Edges of a frozen triangle are never flipped; what it is cut into is frozen too.
    bool frozen = false;
  };

  /// \pre extent is at least 2 x 2.
  explicit LatticeTriangles(Extent extent);

  [[nodiscard]] int count() const { return static_cast<int>(triangles_.size()); }
  [[nodiscard]] const Triangle& operator[](int triangle) const {
    return triangles_[static_cast<std::size_t>(triangle)];
  }
  [[nodiscard]] const std::vector<Corner>& vertices() const { return vertices_; }
  [[nodiscard]] std::array<Corner, 3> corners(int triangle) const;
  /// Twice the area of a, b, c; positive where they turn from x to y.
  [[nodiscard]] static Index area(const Corner& a, const Corner& b, const Corner& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  }
  /// The edge of a triangle (by its opposite corner) that a sample lies on, -1 for inside.
  /// \pre the sample lies in the triangle and is none of its corners.
  [[nodiscard]] int edge_under(int triangle, const Corner& sample) const;

  void freeze(int triangle) { triangles_[static_cast<std::size_t>(triangle)].frozen = true; }
  /// Makes a sample a vertex. \pre as edge_under().
  /// \returns the triangles that are new or changed, some of them perhaps twice; good until the
  /// next call.
  const std::vector<int>& insert(int triangle, const Corner& sample);

 private:
  int add(std::array<int, 3> corners, std::array<int, 3> across, bool frozen);
  void set(int triangle, std::array<int, 3> corners, std::array<int, 3> across);
  void relink(int triangle, int from, int to);
  void cut_inside(int triangle, int vertex);
  void cut_edge(int triangle, int edge, int vertex);
  void restore_delaunay(int vertex);
  [[nodiscard]] bool flips(int triangle, int corner, int beyond, int opposite) const;
  [[nodiscard]] static int corner_of(const Triangle& triangle, int vertex);
  [[nodiscard]] static int edge_to(const Triangle& triangle, int neighbour);

  std::vector<Corner> vertices_;
  std::vector<Triangle> triangles_;
  std::vector<int> changed_;
  std::vector<int> doubtful_;
};

}  // namespace arete
