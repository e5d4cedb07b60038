// SPDX-License-Identifier: GPL-3.0-or-later
#include "arete/meshlab/surface_patch.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "arete/field/at.h"
#include "arete/topology/orient.h"
#include "arete/topology/recover.h"

namespace arete::meshlab {
namespace {

void check_positions(const MeshArrays& mesh) {
  if (mesh.triangles.empty())
    throw InvalidField(mesh.positions.empty()
                           ? "the mesh is empty; open a terrain mesh first"
                           : "the mesh has " + std::to_string(mesh.positions.size()) +
                                 " points but no faces; make a surface of them first");
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    for (double x : mesh.positions[v])
      if (!std::isfinite(x))
        throw InvalidField("vertex " + std::to_string(v) +
                           " has a coordinate that is not a finite number; give it a height or "
                           "delete it");
}

FaceList triangle_list(const MeshArrays& mesh) {
  FaceList faces;
  faces.starts.reserve(mesh.triangles.size() + 1);
  faces.corners.reserve(mesh.triangles.size() * 3);
  for (const Triangle& triangle : mesh.triangles) faces.add(triangle);
  return faces;
}

// Quads by the polygon bits, and the two triangles of each.
struct PairedQuads {
  FaceList faces;
  std::vector<std::array<int, 2>> triangles;
};

// The number of a triangle's only inner edge, -1 if there is none or more than one.
int only_inner_edge(std::uint8_t bits) {
  switch (bits & 7) {
    case 1:
      return 0;
    case 2:
      return 1;
    case 4:
      return 2;
    default:
      return -1;
  }
}

std::optional<PairedQuads> paired_quads(const MeshArrays& mesh) {
  struct InnerEdge {
    int low, high, triangle, edge;
  };
  std::vector<InnerEdge> edges;
  edges.reserve(mesh.triangles.size());
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const int k = only_inner_edge(mesh.inner_edges[f]);
    if (k < 0) return std::nullopt;
    const int a = mesh.triangles[f][at(k)];
    const int b = mesh.triangles[f][at((k + 1) % 3)];
    edges.push_back({std::min(a, b), std::max(a, b), static_cast<int>(f), k});
  }
  if (edges.size() % 2 != 0) return std::nullopt;
  std::sort(edges.begin(), edges.end(), [](const InnerEdge& x, const InnerEdge& y) {
    return std::tie(x.low, x.high, x.triangle) < std::tie(y.low, y.high, y.triangle);
  });
  PairedQuads quads;
  quads.triangles.reserve(edges.size() / 2);
  for (std::size_t i = 0; i < edges.size(); i += 2) {
    const InnerEdge& x = edges[i];
    const InnerEdge& y = edges[i + 1];
    const bool third =
        i + 2 < edges.size() && edges[i + 2].low == x.low && edges[i + 2].high == x.high;
    if (x.low != y.low || x.high != y.high || third) return std::nullopt;
    const Triangle& s = mesh.triangles[at(x.triangle)];
    const Triangle& t = mesh.triangles[at(y.triangle)];
    // Both triangles must look the same way: the mate runs along the edge backwards.
    if (s[at(x.edge)] != t[at((y.edge + 1) % 3)]) return std::nullopt;
    quads.faces.add(std::array{s[at((x.edge + 1) % 3)], s[at((x.edge + 2) % 3)], s[at(x.edge)],
                               t[at((y.edge + 2) % 3)]});
    quads.triangles.push_back({x.triangle, y.triangle});
  }
  return quads;
}

bool has_vertex(const Triangle& triangle, int vertex) {
  return std::find(triangle.begin(), triangle.end(), vertex) != triangle.end();
}

// Replaces the quads of an oriented patch by the triangles they were paired from.
void cut_cells(GridPatch& patch, const MeshArrays& mesh, const PairedQuads& quads) {
  const auto vertex = [&](Index r, Index c) {
    return patch.vertex(r % patch.extent.rows, c % patch.extent.cols);
  };
  for (Index r = 0; r < patch.cell_rows(); ++r) {
    for (Index c = 0; c < patch.cell_cols(); ++c) {
      GridCell& cell = patch.cells[at(r * patch.cell_cols() + c)];
      auto [first, second] = quads.triangles[at(cell.faces[0])];
      const int north_west = vertex(r, c);
      const int north_east = vertex(r, c + 1);
      const auto holds_top = [&](int f) {
        return has_vertex(mesh.triangles[at(f)], north_west) &&
               has_vertex(mesh.triangles[at(f)], north_east);
      };
      if (!holds_top(first)) std::swap(first, second);
      cell.faces = {first, second};
      cell.diagonal =
          has_vertex(mesh.triangles[at(second)], north_west) ? Diagonal::main : Diagonal::anti;
    }
  }
}

std::vector<GridPatch> all_oriented(std::vector<GridPatch> patches, const MeshArrays& mesh) {
  for (GridPatch& patch : patches) patch = oriented(patch, mesh.positions);
  return patches;
}

std::optional<std::vector<GridPatch>> patches_of_quads(const MeshArrays& mesh) {
  const auto quads = paired_quads(mesh);
  if (!quads) return std::nullopt;
  try {
    auto patches = all_oriented(
        recover_grids(quads->faces, static_cast<int>(mesh.positions.size()), mesh.positions), mesh);
    for (GridPatch& patch : patches) cut_cells(patch, mesh, *quads);
    return patches;
  } catch (const NotAGrid&) {
    return std::nullopt;
  }
}

}  // namespace

std::vector<GridPatch> surface_patches(const MeshArrays& mesh, Report& report) {
  check_positions(mesh);
  if (mesh.triangles.size() > (std::size_t{1} << 29))
    throw InvalidField("the mesh has more than 2^29 faces; cut it into parts");
  if (!mesh.inner_edges.empty()) {
    if (auto patches = patches_of_quads(mesh)) return std::move(*patches);
  }
  try {
    auto patches = all_oriented(
        recover_grids(triangle_list(mesh), static_cast<int>(mesh.positions.size()), mesh.positions),
        mesh);
    if (!mesh.inner_edges.empty())
      report.log(
          "The polygon marks of the mesh do not pair its triangles into a grid of quads; "
          "the grid was found from the triangles alone.");
    return patches;
  } catch (const NotAGrid& error) {
    throw InvalidField(std::string("the mesh is not a terrain grid: ") + error.what());
  }
}

}  // namespace arete::meshlab
