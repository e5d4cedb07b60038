// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>
#include <vector>

#include "arete/field/grid.h"
#include "arete/meshlab/mesh_arrays.h"

namespace arete::meshlab::test {

/// How a test mesh is cut and numbered.
struct MeshForm {
  enum class Diagonals { main, anti, alternating, random };
  Diagonals diagonals = Diagonals::main;
  bool quads = false;      ///< mark the diagonals as inside polygons
  bool shuffled = false;   ///< vertices, faces and corners in random order
  bool clockwise = false;  ///< faces look down
  unsigned seed = 1;
};

/// A mesh of a height field, and where its vertices are: numbers[r * cols + c]. Row 0 is the
/// northern one (largest y), the cells are 10 wide and 20 high.
struct GridMesh {
  MeshArrays arrays;
  Extent extent;
  std::vector<int> numbers;
  [[nodiscard]] int vertex(Index r, Index c) const {
    return numbers[static_cast<std::size_t>(r * extent.cols + c)];
  }
};

inline double test_height(Index r, Index c) {
  return 100 * std::sin(0.9 * static_cast<double>(r)) + 7 * std::cos(2.1 * static_cast<double>(c)) +
         static_cast<double>((r * 7 + c * 13) % 5);
}

inline GridMesh grid_mesh(Extent extent, const MeshForm& form = {},
                          const std::function<double(Index, Index)>& height = test_height) {
  std::mt19937 random(form.seed);
  GridMesh mesh{{}, extent, std::vector<int>(static_cast<std::size_t>(extent.rows * extent.cols))};
  std::iota(mesh.numbers.begin(), mesh.numbers.end(), 0);
  if (form.shuffled) std::shuffle(mesh.numbers.begin(), mesh.numbers.end(), random);
  mesh.arrays.positions.resize(mesh.numbers.size());
  for (Index r = 0; r < extent.rows; ++r)
    for (Index c = 0; c < extent.cols; ++c)
      mesh.arrays.positions[static_cast<std::size_t>(mesh.vertex(r, c))] = {
          10 * static_cast<double>(c), 20 * static_cast<double>(extent.rows - 1 - r), height(r, c)};

  struct Face {
    Triangle triangle;
    std::uint8_t inner;
  };
  std::vector<Face> faces;
  for (Index r = 0; r + 1 < extent.rows; ++r) {
    for (Index c = 0; c + 1 < extent.cols; ++c) {
      const int nw = mesh.vertex(r, c);
      const int ne = mesh.vertex(r, c + 1);
      const int se = mesh.vertex(r + 1, c + 1);
      const int sw = mesh.vertex(r + 1, c);
      bool anti = form.diagonals == MeshForm::Diagonals::anti;
      if (form.diagonals == MeshForm::Diagonals::alternating) anti = (r + c) % 2 != 0;
      if (form.diagonals == MeshForm::Diagonals::random) anti = random() % 2 != 0;
      // Counter-clockwise from above.
      if (anti) {
        faces.push_back({{nw, sw, ne}, 2});
        faces.push_back({{sw, se, ne}, 4});
      } else {
        faces.push_back({{nw, se, ne}, 1});
        faces.push_back({{nw, sw, se}, 4});
      }
    }
  }
  for (Face& face : faces) {
    if (form.shuffled) {
      const auto turn = static_cast<int>(random() % 3);
      std::rotate(face.triangle.begin(), face.triangle.begin() + turn, face.triangle.end());
      const int bits = face.inner;
      face.inner = static_cast<std::uint8_t>(((bits >> turn) | (bits << (3 - turn))) & 7);
    }
    if (form.clockwise) {
      std::swap(face.triangle[1], face.triangle[2]);
      // Edges 0 and 2 change places.
      const int bits = face.inner;
      face.inner = static_cast<std::uint8_t>((bits & 2) | ((bits & 1) << 2) | (bits >> 2));
    }
  }
  if (form.shuffled) std::shuffle(faces.begin(), faces.end(), random);
  for (const Face& face : faces) {
    mesh.arrays.triangles.push_back(face.triangle);
    if (form.quads) mesh.arrays.inner_edges.push_back(face.inner);
  }
  return mesh;
}

/// The heights of a grid mesh, row by row.
inline Grid<double> heights_of(const GridMesh& mesh) {
  Grid<double> heights(mesh.extent);
  for (Index r = 0; r < mesh.extent.rows; ++r)
    for (Index c = 0; c < mesh.extent.cols; ++c)
      heights(r, c) = mesh.arrays.positions[static_cast<std::size_t>(mesh.vertex(r, c))][2];
  return heights;
}

/// z component of the normal of a triangle seen from above: > 0 looks up.
inline double area_from_above(const std::vector<Point3>& p, const Triangle& t) {
  const Point3& a = p[static_cast<std::size_t>(t[0])];
  const Point3& b = p[static_cast<std::size_t>(t[1])];
  const Point3& c = p[static_cast<std::size_t>(t[2])];
  return ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
}

}  // namespace arete::meshlab::test
