// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

#include "arete/topology/face_list.h"
#include "arete/topology/grid_faces.h"
#include "arete/topology/grid_patch.h"

namespace arete::test {

/// A mesh as plain arrays.
struct Mesh {
  std::vector<Point3> points;
  FaceList faces;

  [[nodiscard]] int vertices() const { return static_cast<int>(points.size()); }
};

/// Quads over a hilly terrain: vertex r cols + c lies at x = c, y = -r.
inline Mesh terrain_mesh(Index rows, Index cols) {
  Mesh mesh;
  for (Index r = 0; r < rows; ++r)
    for (Index c = 0; c < cols; ++c) {
      const double x = static_cast<double>(c);
      const double y = static_cast<double>(r);
      mesh.points.push_back({x, -y, std::sin(1.3 * x + 0.2 * y) + 0.3 * std::cos(2.1 * y)});
    }
  // North to south and west to east is clockwise, so turn the faces up.
  mesh.faces = grid_faces({rows, cols}, true);
  return mesh;
}

/// A tube of `rows` rings of `around` vertices.
inline Mesh tube_mesh(Index rows, Index around) {
  Mesh mesh;
  for (Index r = 0; r < rows; ++r)
    for (Index c = 0; c < around; ++c) {
      const double angle =
          2 * std::numbers::pi * static_cast<double>(c) / static_cast<double>(around);
      mesh.points.push_back({std::cos(angle), std::sin(angle), static_cast<double>(r)});
    }
  mesh.faces = grid_faces({rows, around}, false, false, true);
  return mesh;
}

inline Mesh torus_mesh(Index rows, Index cols) {
  Mesh mesh;
  for (Index r = 0; r < rows; ++r)
    for (Index c = 0; c < cols; ++c) {
      const double u = 2 * std::numbers::pi * static_cast<double>(c) / static_cast<double>(cols);
      const double v = 2 * std::numbers::pi * static_cast<double>(r) / static_cast<double>(rows);
      const double radius = 5 + 2 * std::cos(v);
      mesh.points.push_back({radius * std::cos(u), radius * std::sin(u), 2 * std::sin(v)});
    }
  mesh.faces = grid_faces({rows, cols}, false, true, true);
  return mesh;
}

/// Cuts every quad along the diagonal from its first corner (true) or its second.
inline Mesh triangulated(const Mesh& mesh, const std::function<bool(int)>& from_first) {
  Mesh result{mesh.points, {}};
  for (int f = 0; f < mesh.faces.count(); ++f) {
    const auto q = mesh.faces[f];
    const int s = from_first(f) ? 0 : 1;
    const auto corner = [&](int i) { return q[static_cast<std::size_t>((s + i) % 4)]; };
    result.faces.add(std::vector<int>{corner(0), corner(1), corner(2)});
    result.faces.add(std::vector<int>{corner(0), corner(2), corner(3)});
  }
  return result;
}

/// The same mesh with vertices, faces and the first corner of every face in random order.
/// new_vertex[v] is the new number of vertex v.
inline Mesh shuffled(const Mesh& mesh, unsigned seed, std::vector<int>* new_vertex = nullptr) {
  std::mt19937 random(seed);
  std::vector<int> to(mesh.points.size());
  std::iota(to.begin(), to.end(), 0);
  std::shuffle(to.begin(), to.end(), random);
  std::vector<int> faces(static_cast<std::size_t>(mesh.faces.count()));
  std::iota(faces.begin(), faces.end(), 0);
  std::shuffle(faces.begin(), faces.end(), random);
  Mesh result;
  result.points.resize(mesh.points.size());
  for (std::size_t v = 0; v < to.size(); ++v)
    result.points[static_cast<std::size_t>(to[v])] = mesh.points[v];
  for (int f : faces) {
    std::vector<int> face;
    for (int v : mesh.faces[f]) face.push_back(to[static_cast<std::size_t>(v)]);
    std::rotate(face.begin(), face.begin() + static_cast<long>(random() % face.size()), face.end());
    result.faces.add(face);
  }
  if (new_vertex) *new_vertex = to;
  return result;
}

/// Two meshes side by side, the vertices of the second after those of the first.
inline Mesh joined(const Mesh& a, const Mesh& b) {
  Mesh result = a;
  result.points.insert(result.points.end(), b.points.begin(), b.points.end());
  for (int f = 0; f < b.faces.count(); ++f) {
    std::vector<int> face;
    for (int v : b.faces[f]) face.push_back(v + a.vertices());
    result.faces.add(face);
  }
  return result;
}

/// The mesh without some of its faces.
inline Mesh without_faces(const Mesh& mesh, const std::vector<int>& removed) {
  Mesh result{mesh.points, {}};
  for (int f = 0; f < mesh.faces.count(); ++f)
    if (std::find(removed.begin(), removed.end(), f) == removed.end())
      result.faces.add(mesh.faces[f]);
  return result;
}

/// The mesh with every face turned over.
inline Mesh turned_over(const Mesh& mesh) {
  Mesh over{mesh.points, {}};
  for (int f = 0; f < mesh.faces.count(); ++f) {
    std::vector<int> face(mesh.faces[f].begin(), mesh.faces[f].end());
    std::reverse(face.begin(), face.end());
    over.faces.add(face);
  }
  return over;
}

/// Whether the corners of face f, from some corner on, are these.
inline bool runs(const FaceList& faces, int f, std::vector<int> corners) {
  const auto face = faces[f];
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (std::equal(face.begin(), face.end(), corners.begin(), corners.end())) return true;
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
  }
  return false;
}

/// What GridPatch promises: every cell's faces have the cell's corners, in the promised order, and
/// no face or vertex comes twice.
inline bool is_consistent(const GridPatch& patch, const FaceList& faces) {
  std::vector<int> used;
  for (Index r = 0; r < patch.cell_rows(); ++r) {
    for (Index c = 0; c < patch.cell_cols(); ++c) {
      const Index below = (r + 1) % patch.extent.rows;
      const Index right = (c + 1) % patch.extent.cols;
      const int a = patch.vertex(r, c), b = patch.vertex(r, right);
      const int d = patch.vertex(below, right), e = patch.vertex(below, c);
      std::vector<std::vector<int>> expected;
      const GridCell& cell = patch.cell(r, c);
      if (cell.diagonal == Diagonal::none) expected = {{a, b, d, e}};
      if (cell.diagonal == Diagonal::main) expected = {{a, b, d}, {a, d, e}};
      if (cell.diagonal == Diagonal::anti) expected = {{a, b, e}, {e, b, d}};
      for (std::size_t i = 0; i < expected.size(); ++i) {
        if (patch.mirrored) std::reverse(expected[i].begin(), expected[i].end());
        if (!runs(faces, cell.faces[i], expected[i])) return false;
        used.push_back(cell.faces[i]);
      }
    }
  }
  const auto distinct = [](std::vector<int> numbers) {
    std::sort(numbers.begin(), numbers.end());
    return std::adjacent_find(numbers.begin(), numbers.end()) == numbers.end();
  };
  return distinct(used) && distinct(patch.vertices);
}

}  // namespace arete::test
