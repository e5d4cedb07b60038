// SPDX-License-Identifier: MIT
#include "arete/openmesh/internal/corner_attributes.h"

#include <cmath>
#include <memory>

#include "arete/field/at.h"
#include "arete/openmesh/internal/known_types.h"

namespace arete::openmesh::detail {
namespace {

using OpenMesh::ArrayKernel;
using OpenMesh::BaseProperty;
using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::PropertyT;

// Corners of a cell: 0 (r, c), 1 (r, c+1), 2 (r+1, c), 3 (r+1, c+1).
// For each old cell and each of its faces, the half-edges that end in the corners; -1 where a
// triangle has none.
using CornerTable = std::vector<std::array<std::array<int, 4>, 2>>;

// Calls f(corner, half-edge) around a face.
template <class F>
void around(const ArrayKernel& mesh, int face, const std::array<int, 4>& corners, F&& f) {
  const HalfedgeHandle first = mesh.halfedge_handle(FaceHandle(face));
  HalfedgeHandle h = first;
  do {
    const int v = mesh.to_vertex_handle(h).idx();
    for (std::size_t k = 0; k < 4; ++k)
      if (corners[k] == v) f(k, h.idx());
    h = mesh.next_halfedge_handle(h);
  } while (h != first);
}

CornerTable corner_table(const ArrayKernel& mesh, const GridPatch& patch) {
  CornerTable table(patch.cells.size());
  for (Index r = 0; r < patch.cell_rows(); ++r) {
    for (Index c = 0; c < patch.cell_cols(); ++c) {
      const Index below = (r + 1) % patch.extent.rows;
      const Index right = (c + 1) % patch.extent.cols;
      const std::array<int, 4> corners{patch.vertex(r, c), patch.vertex(r, right),
                                       patch.vertex(below, c), patch.vertex(below, right)};
      auto& entry = table[at(r * patch.cell_cols() + c)];
      for (std::size_t half = 0; half < 2; ++half) {
        entry[half].fill(-1);
        const int face = patch.cell(r, c).faces[half];
        if (face >= 0)
          around(mesh, face, corners, [&](std::size_t k, int h) { entry[half][k] = h; });
      }
    }
  }
  return table;
}

// Weights of the four corners at (u, v) in a quad, or in one triangle of a cut cell.
std::array<double, 4> weights(Diagonal diagonal, int half, double u, double v) {
  if (diagonal == Diagonal::none) return {(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v};
  if (diagonal == Diagonal::main)
    return half == 0 ? std::array<double, 4>{1 - u, u - v, 0, v}
                     : std::array<double, 4>{1 - v, 0, v - u, u};
  return half == 0 ? std::array<double, 4>{1 - u - v, u, v, 0}
                   : std::array<double, 4>{0, 1 - v, 1 - u, u + v - 1};
}

// Places that are old vertices but for rounding are old vertices.
double snapped(double t) {
  if (std::abs(t) < 1e-12) return 0;
  return std::abs(t - 1) < 1e-12 ? 1 : t;
}

template <class T>
T blended(const std::vector<T>& old, const std::array<int, 4>& corners,
          const std::array<double, 4>& w, bool unit) {
  using C = Components<T>;
  std::array<double, C::count> sums{};
  double squared = 0;
  for (std::size_t k = 0; k < C::count; ++k) {
    // Relative to one of the corners, so that equal values stay as they are.
    double base = 0;
    bool first = true;
    for (std::size_t i = 0; i < 4; ++i) {
      if (corners[i] < 0) continue;
      const auto x = static_cast<double>(C::get(old[at(corners[i])], k));
      if (first)
        base = x;
      else
        sums[k] += w[i] * (x - base);
      first = false;
    }
    sums[k] += base;
    squared += sums[k] * sums[k];
  }
  const double scale = unit && squared > 0 ? 1 / std::sqrt(squared) : 1;
  T value = zero<T>();
  for (std::size_t k = 0; k < C::count; ++k)
    C::set(value, k, rounded<typename C::Scalar>(scale * sums[k]));
  return value;
}

template <class T>
void refine_corners(const ArrayKernel& mesh, const RefinedPatch& patch, const CornerTable& table,
                    const std::vector<T>& old, std::vector<T>& values, bool unit) {
  const auto half_row = to_double(patch.rows.plan.spacing()) / 2;
  const auto half_col = to_double(patch.cols.plan.spacing()) / 2;
  const std::size_t cols = at(patch.cols.fine());
  std::vector<int> top(cols);
  std::vector<int> bottom(cols);
  for (Index r = 0; r < patch.rows.fine_cells(); ++r) {
    patch.row_vertices(r, top);
    patch.row_vertices((r + 1) % patch.rows.fine(), bottom);
    const Location y = patch.rows.middles[at(r)];
    for (Index c = 0; c < patch.cols.fine_cells(); ++c) {
      const Location x = patch.cols.middles[at(c)];
      const std::size_t left = at(c);
      const std::size_t right = (left + 1) % cols;
      const std::array<int, 4> corners{top[left], top[right], bottom[left], bottom[right]};
      const auto& parent = table[at(y.cell * patch.coarse.cell_cols() + x.cell)];
      const Diagonal diagonal = patch.parent(r, c).diagonal;
      for (int half = 0; half < (patch.triangles() ? 2 : 1); ++half) {
        const int from = patch.triangles() ? patch.parent_half(r, c, half) : 0;
        around(mesh, patch.face(r, c) + half, corners, [&](std::size_t k, int h) {
          const double u = snapped(x.t + (k % 2 == 0 ? -half_col : half_col));
          const double v = snapped(y.t + (k < 2 ? -half_row : half_row));
          values[at(h)] = blended(old, parent[at(from)], weights(diagonal, from, u, v), unit);
        });
      }
    }
  }
}

}  // namespace

std::vector<Job> corner_jobs(ArrayKernel& mesh, const Rebuild& rebuild,
                             const std::set<const BaseProperty*>& skipped) {
  std::vector<Job> jobs;
  std::shared_ptr<std::vector<CornerTable>> tables;
  for (auto it = mesh.hprops_begin(); it != mesh.hprops_end(); ++it) {
    if (!*it || skipped.count(*it) != 0) continue;
    const bool unit = (*it)->name() == "h:normals";
    KnownTypes::visit(**it, [&]<class T>(PropertyT<T>& typed) {
      if (!tables) {
        tables = std::make_shared<std::vector<CornerTable>>();
        for (const RefinedPatch& patch : rebuild.patches)
          tables->push_back(corner_table(mesh, patch.coarse));
      }
      jobs.push_back([&mesh, &rebuild, &typed, unit, tables, old = typed.data_vector()] {
        std::vector<T>& values = typed.data_vector();
        std::fill(values.begin(), values.end(), zero<T>());
        for (std::size_t p = 0; p < tables->size(); ++p)
          refine_corners(mesh, rebuild.patches[p], (*tables)[p], old, values, unit);
      });
    });
  }
  return jobs;
}

}  // namespace arete::openmesh::detail
