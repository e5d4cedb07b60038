// SPDX-License-Identifier: MIT
#include "arete/topology/recover.h"

#include <string>
#include <utility>

#include "arete/field/at.h"
#include "arete/topology/half_edges.h"
#include "arete/topology/recover_part.h"

namespace arete {
namespace {

std::vector<std::vector<int>> components(const HalfEdges& mesh) {
  const int faces = mesh.faces().count();
  std::vector<int> component_of(at(faces), -1);
  std::vector<int> reached;
  int found = 0;
  for (int seed = 0; seed < faces; ++seed) {
    if (component_of[at(seed)] >= 0) continue;
    component_of[at(seed)] = found;
    reached.assign(1, seed);
    for (std::size_t i = 0; i < reached.size(); ++i) {
      const int begin = mesh.faces().starts[at(reached[i])];
      const int end = mesh.faces().starts[at(reached[i]) + 1];
      for (int h = begin; h < end; ++h) {
        if (mesh.twin(h) < 0) continue;
        const int neighbour = mesh.face(mesh.twin(h));
        if (component_of[at(neighbour)] >= 0) continue;
        component_of[at(neighbour)] = found;
        reached.push_back(neighbour);
      }
    }
    ++found;
  }
  std::vector<std::vector<int>> components(at(found));
  for (int f = 0; f < faces; ++f) components[at(component_of[at(f)])].push_back(f);
  return components;
}

}  // namespace

std::vector<GridPatch> recover_grids(const FaceList& faces, int vertex_count,
                                     std::span<const Point3> positions) {
  if (auto patch = detail::recover_in_order(faces, vertex_count)) return {std::move(*patch)};
  const HalfEdges mesh(faces, vertex_count);
  detail::Marks marks(faces.count(), vertex_count);
  std::vector<GridPatch> patches;
  std::vector<bool> taken(at(vertex_count), false);
  for (const std::vector<int>& component : components(mesh)) {
    const std::size_t size = faces[component.front()].size();
    for (int f : component)
      if (faces[f].size() != size)
        throw NotAGrid::at_face(f, "has " + std::to_string(faces[f].size()) + " corners, face " +
                                       std::to_string(component.front()) +
                                       " of the same part has " + std::to_string(size) +
                                       "; make the mesh all quads or all triangles");
    GridPatch patch = size == 4 ? detail::recover_quads(mesh, component, marks)
                                : detail::recover_triangles(mesh, component, marks, positions);
    for (int v : patch.vertices) {
      if (taken[at(v)])
        throw NotAGrid::at_vertex(v,
                                  "is at two places of the grid: parts of the surface touch "
                                  "there; split it");
      taken[at(v)] = true;
    }
    patches.push_back(std::move(patch));
  }
  return patches;
}

}  // namespace arete
