// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <map>
#include <random>
#include <string>
#include <utility>

#include "arete/reverse/mesh_step.h"
#include "support/oracle.h"

namespace arete::test {

inline MeshFaces mesh_of(const nlohmann::json& faces) {
  MeshFaces mesh;
  for (const auto& face : faces) {
    mesh.faces.push_back(face.get<std::vector<Index>>());
    for (const Index v : mesh.faces.back()) mesh.vertices = std::max(mesh.vertices, v + 1);
  }
  return mesh;
}

inline MeshFaces prism(Index n) {
  MeshFaces mesh{2 * n, {{}, {}}};
  for (Index i = 0; i < n; ++i) {
    mesh.faces[0].push_back(n - 1 - i);
    mesh.faces[1].push_back(n + i);
    mesh.faces.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
  }
  return mesh;
}

inline MeshFaces bipyramid(Index n) {
  MeshFaces mesh{n + 2, {}};
  for (Index i = 0; i < n; ++i) {
    mesh.faces.push_back({i, (i + 1) % n, n});
    mesh.faces.push_back({(i + 1) % n, i, n + 1});
  }
  return mesh;
}

inline MeshFaces tetrahedron() { return {4, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}}; }

inline MeshFaces torus(Index rows, Index cols, bool triangles) {
  MeshFaces mesh{rows * cols, {}};
  for (Index r = 0; r < rows; ++r)
    for (Index c = 0; c < cols; ++c) {
      const auto at = [&](Index i, Index j) { return (i % rows) * cols + j % cols; };
      const Index a = at(r, c), b = at(r, c + 1), d = at(r + 1, c + 1), e = at(r + 1, c);
      if (!triangles) {
        mesh.faces.push_back({a, b, d, e});
        continue;
      }
      mesh.faces.push_back({a, b, d});
      mesh.faces.push_back({a, d, e});
    }
  return mesh;
}

inline MeshFaces open_grid(Index rows, Index cols, bool triangles) {
  MeshFaces mesh{rows * cols, {}};
  for (Index r = 0; r + 1 < rows; ++r)
    for (Index c = 0; c + 1 < cols; ++c) {
      const Index a = r * cols + c;
      if (!triangles) {
        mesh.faces.push_back({a, a + 1, a + cols + 1, a + cols});
        continue;
      }
      mesh.faces.push_back({a, a + 1, a + cols + 1});
      mesh.faces.push_back({a, a + cols + 1, a + cols});
    }
  return mesh;
}

/// An open fan of n triangles around vertex 0, and a pentagon beside the first.
inline MeshFaces open_fan(Index n, bool pentagon) {
  MeshFaces mesh{n + 2, {}};
  for (Index i = 1; i <= n; ++i) mesh.faces.push_back({0, i, i + 1});
  if (pentagon) {
    mesh.faces.push_back({2, 1, n + 2, n + 3, n + 4});
    mesh.vertices += 3;
  }
  return mesh;
}

/// Meshes with boundary and without, of valences 3 to 9, faces of 3 to 7 corners.
inline std::map<std::string, MeshFaces> control_meshes(MeshRule rule) {
  std::map<std::string, MeshFaces> meshes{{"tetrahedron", tetrahedron()},
                                          {"octahedron", bipyramid(4)},
                                          {"bipyramid 7", bipyramid(7)},
                                          {"torus of triangles", torus(4, 5, true)}};
  if (rule.scheme != MeshScheme::doo_sabin) {
    meshes["open grid of triangles"] = open_grid(4, 5, true);
    meshes["fan"] = open_fan(5, false);
  }
  if (rule.triangles()) return meshes;
  meshes["prism 3"] = prism(3);
  meshes["prism 5"] = prism(5);
  meshes["prism 7"] = prism(7);
  meshes["torus"] = torus(3, 4, false);
  if (rule.scheme == MeshScheme::doo_sabin) {
    meshes["cube"] = prism(4);
    return meshes;
  }
  meshes["open grid"] = open_grid(3, 5, false);
  meshes["fan with a pentagon"] = open_fan(4, true);
  return meshes;
}

/// One row a vertex.
inline Grid<double> random_positions(Index vertices, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-10, 10);
  Grid<double> positions({vertices, 3});
  for (double& x : positions.samples()) x = number(random);
  return positions;
}

template <class R>
Grid<R> subdivided_positions(const MeshStep<R>& step, const Grid<R>& coarse) {
  Grid<R> fine({step.s.rows(), coarse.cols()});
  step.s.multiply({coarse.row(0), coarse.rows(), coarse.cols(), coarse.cols()},
                  {fine.row(0), fine.rows(), fine.cols(), fine.cols()});
  return fine;
}

}  // namespace arete::test
