// SPDX-License-Identifier: MIT
#include "arete/openmesh/internal/rebuild.h"

#include <algorithm>
#include <limits>
#include <string>

namespace arete::openmesh::detail {
namespace {

AxisPlan make_plan(const Scheme& scheme, Index count, bool wraps, Boundary boundary, int levels,
                   const std::optional<Stencil>& final_stencil) {
  AxisOptions options;
  options.levels = levels;
  options.boundary = wraps ? Boundary::periodic : boundary;
  options.final_stencil = final_stencil;
  return {scheme.mask(), count, options};
}

// Before anything is allocated: all half-edges need a number.
void check_size(double half_edges) {
  if (half_edges > std::numeric_limits<int>::max())
    throw InvalidField(
        "the refined mesh would have " + std::to_string(half_edges / 2e9) +
        "e9 edges, more than OpenMesh's 32-bit handles can number; use fewer levels");
}

}  // namespace

Index RefinedPatch::new_vertices() const {
  const Index all = rows.fine() * cols.fine();
  return keeps_vertices ? all - rows.coarse() * cols.coarse() : all;
}

Index RefinedPatch::edges() const {
  return rows.fine() * cols.fine_cells() + rows.fine_cells() * cols.fine() +
         (triangles() ? rows.fine_cells() * cols.fine_cells() : 0);
}

void RefinedPatch::row_vertices(Index r, std::span<int> out) const {
  int* const begin = out.data();
  const auto fine = static_cast<int>(cols.fine());
  if (!keeps_vertices) {
    const int first = first_vertex + static_cast<int>(r) * fine;
    for (int c = 0; c < fine; ++c) begin[c] = first + c;
    return;
  }
  const Index old_rows_before = (r + rows.stride - 1) / rows.stride;
  int next = first_vertex + static_cast<int>(r * cols.fine() - old_rows_before * cols.coarse());
  if (r % rows.stride != 0) {
    for (int c = 0; c < fine; ++c) begin[c] = next + c;
    return;
  }
  const int* const old = coarse.vertices.data() + r / rows.stride * cols.coarse();
  const auto stride = static_cast<int>(cols.stride);
  for (int i = 0, c = 0; c < fine; ++i) {
    begin[c++] = old[i];
    for (int k = 1; k < stride && c < fine; ++k) begin[c++] = next++;
  }
}

int RefinedPatch::parent_half(Index cell_row, Index cell_col, int half) const {
  // Both are cut the same way, so the fine triangle lies on one side of the old diagonal, or its
  // cell lies on it and the halves correspond.
  const Location v = rows.middles[static_cast<std::size_t>(cell_row)];
  const Location u = cols.middles[static_cast<std::size_t>(cell_col)];
  const bool main = parent(cell_row, cell_col).diagonal == Diagonal::main;
  const double side = main ? u.t - v.t : 1 - u.t - v.t;
  // Rounded places of arity 3 and more may miss the diagonal by a little.
  if (side > 1e-9) return 0;
  if (side < -1e-9) return 1;
  return half;
}

Rebuild plan_rebuild(std::vector<GridPatch> patches, int old_vertices,
                     const RebuildOptions& options) {
  if (patches.empty()) throw InvalidField("the mesh has no faces; there is nothing to refine");
  for (Boundary boundary : {options.boundaries.x, options.boundaries.y})
    if (boundary == Boundary::periodic)
      throw InvalidField(
          "boundary periodic is for meshes that close on themselves and is then taken "
          "without asking; choose the rule of the open rims: extrapolate, clamp, "
          "reflect or none");
  Rebuild rebuild;
  rebuild.old_vertices = old_vertices;
  std::vector<bool> used(static_cast<std::size_t>(old_vertices), false);
  bool keep = true;
  double half_edges = 0;
  for (GridPatch& patch : patches) {
    for (int v : patch.vertices) used[static_cast<std::size_t>(v)] = true;
    AxisPlan y = make_plan(options.along_cols, patch.extent.rows, patch.wraps_rows,
                           options.boundaries.y, options.levels, options.final_along_cols);
    AxisPlan x = make_plan(options.along_rows, patch.extent.cols, patch.wraps_cols,
                           options.boundaries.x, options.levels, options.final_along_rows);
    half_edges += (patch.is_triangulated() ? 6.0 : 4.0) * static_cast<double>(y.output_count()) *
                  static_cast<double>(x.output_count());
    check_size(half_edges);
    RefinedAxis rows = refined_axis(std::move(y), patch.wraps_rows);
    RefinedAxis cols = refined_axis(std::move(x), patch.wraps_cols);
    RefinedPatch refined{std::move(patch), std::move(rows), std::move(cols)};
    keep = keep && refined.rows.stride > 0 && refined.cols.stride > 0;
    rebuild.patches.push_back(std::move(refined));
  }

  rebuild.vertices = keep ? old_vertices : 0;
  for (RefinedPatch& patch : rebuild.patches) {
    patch.keeps_vertices = keep;
    patch.first_vertex = rebuild.vertices;
    patch.first_edge = rebuild.edges;
    patch.first_face = rebuild.faces;
    rebuild.vertices += static_cast<int>(patch.new_vertices());
    rebuild.edges += static_cast<int>(patch.edges());
    rebuild.faces += static_cast<int>(patch.faces());
  }
  for (int v = 0; v < old_vertices; ++v)
    if (!used[static_cast<std::size_t>(v)])
      rebuild.lone_vertices.emplace_back(v, keep ? v : rebuild.vertices++);
  return rebuild;
}

}  // namespace arete::openmesh::detail
