// SPDX-License-Identifier: MIT
#include "arete/openmesh/internal/edge_attributes.h"

#include <cmath>
#include <vector>

#include "arete/field/at.h"
#include "arete/openmesh/internal/gather.h"
#include "arete/openmesh/internal/known_types.h"

namespace arete::openmesh::detail {
namespace {

using OpenMesh::ArrayKernel;
using OpenMesh::BaseProperty;
using OpenMesh::HalfedgeHandle;
using OpenMesh::PropertyT;
using OpenMesh::VertexHandle;

// The old half-edge from one vertex to another.
int half_edge(const ArrayKernel& mesh, int from, int to) {
  const HalfedgeHandle first = mesh.halfedge_handle(VertexHandle(from));
  HalfedgeHandle h = first;
  do {
    if (mesh.to_vertex_handle(h).idx() == to) return h.idx();
    h = mesh.next_halfedge_handle(mesh.opposite_halfedge_handle(h));
  } while (h != first);
  return -1;
}

// For every new half-edge the old one it lies on, -1 if none.
class ParentHalfEdges {
 public:
  ParentHalfEdges(const ArrayKernel& mesh, const Rebuild& rebuild)
      : mesh_(mesh), parents_(at(2 * Index{rebuild.edges}), -1) {
    for (const RefinedPatch& patch : rebuild.patches) add(patch);
  }
  [[nodiscard]] const std::vector<int>& half_edges() const { return parents_; }
  [[nodiscard]] std::vector<int> edges() const {
    std::vector<int> edges;
    for (std::size_t h = 0; h < parents_.size(); h += 2)
      edges.push_back(parents_[h] < 0 ? -1 : parents_[h] / 2);
    return edges;
  }

 private:
  void add(const RefinedPatch& patch) {
    const GridPatch& old = patch.coarse;
    const Extent n = old.extent;
    const bool mirrored = old.mirrored;
    for (Index r = 0; r < patch.rows.fine(); ++r) {
      const Index row = patch.rows.samples[at(r)].sample;
      if (row < 0) continue;
      for (Index c = 0; c < patch.cols.fine_cells(); ++c) {
        const Index col = patch.cols.middles[at(c)].cell;
        set(patch.edge_along_row(r, c), old.vertex(row % n.rows, col),
            old.vertex(row % n.rows, (col + 1) % n.cols), mirrored);
      }
    }
    for (Index r = 0; r < patch.rows.fine_cells(); ++r) {
      const Index row = patch.rows.middles[at(r)].cell;
      for (Index c = 0; c < patch.cols.fine(); ++c) {
        const Index col = patch.cols.samples[at(c)].sample;
        if (col >= 0)
          set(patch.edge_to_next_row(r, c), old.vertex(row, col % n.cols),
              old.vertex((row + 1) % n.rows, col % n.cols), false);
      }
    }
    if (patch.triangles()) add_diagonals(patch);
  }

  void add_diagonals(const RefinedPatch& patch) {
    const GridPatch& old = patch.coarse;
    for (Index r = 0; r < patch.rows.fine_cells(); ++r) {
      for (Index c = 0; c < patch.cols.fine_cells(); ++c) {
        const Location v = patch.rows.middles[at(r)];
        const Location u = patch.cols.middles[at(c)];
        const bool main = patch.parent(r, c).diagonal == Diagonal::main;
        if (std::abs(main ? u.t - v.t : 1 - u.t - v.t) > 1e-9) continue;
        // Half-edge 0 of a diagonal runs, in the frame of the faces, against or with the rows as
        // PatchWriter lays it: towards row r for one kind of cell, towards row r + 1 for the other.
        const Index next_row = (v.cell + 1) % old.extent.rows;
        const Index next_col = (u.cell + 1) % old.extent.cols;
        const int top = old.vertex(v.cell, main ? u.cell : next_col);
        const int bottom = old.vertex(next_row, main ? next_col : u.cell);
        set(patch.diagonal(r, c), top, bottom, main != old.mirrored);
      }
    }
  }

  void set(int edge, int from, int to, bool swapped) {
    const int h = half_edge(mesh_, from, to);
    parents_[at(2 * Index{edge})] = swapped ? h ^ 1 : h;
    parents_[at(2 * Index{edge} + 1)] = swapped ? h : h ^ 1;
  }

  const ArrayKernel& mesh_;
  std::vector<int> parents_;
};

// Numbers and vectors default to zero, which OpenMesh's own vectors would not.
void gather_or_zero(BaseProperty& property, std::span<const int> sources) {
  const bool known = KnownTypes::visit(property, [&]<class T>(PropertyT<T>& typed) {
    const std::vector<T> old = typed.data_vector();
    std::vector<T> values(sources.size(), zero<T>());
    for (std::size_t i = 0; i < sources.size(); ++i)
      if (sources[i] >= 0) values[i] = old[at(sources[i])];
    typed.data_vector() = std::move(values);
  });
  if (!known) gather(property, sources);
}

}  // namespace

void refine_edge_attributes(ArrayKernel& mesh, const Rebuild& rebuild,
                            const std::set<const BaseProperty*>& skipped) {
  std::vector<BaseProperty*> of_edges;
  std::vector<BaseProperty*> of_half_edges;
  for (auto it = mesh.eprops_begin(); it != mesh.eprops_end(); ++it)
    if (*it && skipped.count(*it) == 0) of_edges.push_back(*it);
  for (auto it = mesh.hprops_begin(); it != mesh.hprops_end(); ++it) {
    if (!*it || skipped.count(*it) != 0) continue;
    const bool number = KnownTypes::visit(**it, []<class T>(PropertyT<T>&) {});
    if (!number) of_half_edges.push_back(*it);
  }
  if (of_edges.empty() && of_half_edges.empty()) return;
  const ParentHalfEdges parents(mesh, rebuild);
  const std::vector<int> edges = parents.edges();
  for (BaseProperty* property : of_edges) gather_or_zero(*property, edges);
  for (BaseProperty* property : of_half_edges) gather(*property, parents.half_edges());
}

}  // namespace arete::openmesh::detail
