// SPDX-License-Identifier: MIT
#include "arete/reverse/grid_mesh.h"

#include <limits>
#include <optional>
#include <string>

#include "arete/reverse/grid_step.h"
#include "arete/reverse/mesh_draft.h"
#include "arete/topology/orient.h"
#include "arete/topology/recover.h"

namespace arete {
namespace {

[[noreturn]] void refuse(const std::string& reason) {
  throw InvalidField("schemes of the catalogue are undone on one regular grid of quads: " + reason +
                     "; for other meshes take catmull-clark, loop, loop-warren or doo-sabin");
}

std::vector<Point3> points_of(GridView<const double> positions) {
  std::vector<Point3> points;
  for (Index v = 0; v < positions.rows(); ++v)
    points.push_back({positions(v, 0), positions(v, 1), positions(v, 2)});
  return points;
}

GridPatch grid_of(const MeshFaces& fine, GridView<const double> positions) {
  if (fine.vertices > std::numeric_limits<int>::max())
    throw InvalidField("the mesh exceeds 32-bit numbering; split it");
  const std::vector<Point3> points = points_of(positions);
  try {
    const auto patches = recover_grids(face_list(fine), static_cast<int>(fine.vertices), points);
    if (patches.size() != 1)
      refuse("the mesh has " + std::to_string(patches.size()) + " connected parts");
    if (patches.front().is_triangulated()) refuse("its cells are cut into triangles");
    if (static_cast<Index>(patches.front().vertices.size()) != fine.vertices)
      refuse("the mesh has vertices that are in no face");
    return oriented(patches.front(), points);
  } catch (const NotAGrid& error) {
    refuse(error.what());
  }
}

Boundary along(Boundary wanted, bool wraps) {
  if (wraps) return Boundary::periodic;
  if (wanted == Boundary::periodic)
    throw InvalidField(
        "boundary periodic: this axis of the mesh has two ends; choose extrapolate, "
        "clamp or reflect");
  return wanted;
}

MeshDecomposition<double> taken_apart(const MeshFaces& fine, const std::vector<Index>& vertices,
                                      GridView<const double> positions, const GridStep& step,
                                      ReverseMode mode) {
  MeshDecomposition<double> parts;
  parts.mesh.coarse = step.coarse_faces();
  parts.mesh.grid = std::make_shared<const GridStep>(step);
  Grid<double> ordered(positions.extent());
  for (const Index i : step.order()) {
    const Index v = vertices[static_cast<std::size_t>(i)];
    std::copy_n(positions.row(v), positions.cols(),
                ordered.row(static_cast<Index>(parts.mesh.place.size())));
    parts.mesh.place.push_back(v);
  }
  if (!recovery::fits(fine, parts.mesh, parts.rule.scheme))
    refuse("its rows and columns do not give its faces");
  parts.coarse = step.reversed(std::as_const(ordered).view(), mode);
  recovery::set_details(parts, positions);
  return parts;
}

double squared(const Grid<double>& numbers) {
  double sum = 0;
  for (const double x : numbers.samples()) sum += x * x;
  return sum;
}

// A closed axis has no first vertex: every phase is tried, and at first both directions, and what
// has the smallest details is taken. `step` takes the direction found.
MeshDecomposition<double> best_of_phases(const MeshFaces& fine, const std::vector<Index>& vertices,
                                         GridView<const double> positions, GridStep& step,
                                         ReverseMode mode, bool directions) {
  const auto [rows, cols] = step.fine;
  const Index arity = step.scheme.mask().arity();
  const Index row_phases = step.wraps_rows() ? arity : 1;
  const Index col_phases = step.wraps_cols() ? arity : 1;
  const int row_turns = directions && step.wraps_rows() ? 2 : 1;
  const int col_turns = directions && step.wraps_cols() ? 2 : 1;
  std::optional<MeshDecomposition<double>> best;
  double least = 0;
  GridStep found = step;
  for (int turn = 0; turn < row_turns * col_turns; ++turn)
    for (Index phase = 0; phase < row_phases * col_phases; ++phase) {
      const bool up = turn % row_turns == 1;
      const bool left = turn / row_turns == 1;
      GridStep tried = step;
      tried.mirrored = step.mirrored != (up != left);
      std::vector<Index> turned;
      for (Index r = 0; r < rows; ++r)
        for (Index c = 0; c < cols; ++c) {
          const Index row = ((up ? rows - r : r) + phase % row_phases) % rows;
          const Index col = ((left ? cols - c : c) + phase / row_phases) % cols;
          turned.push_back(vertices[static_cast<std::size_t>(row * cols + col)]);
        }
      auto parts = taken_apart(fine, turned, positions, tried, mode);
      const double size = squared(parts.details);
      if (best && !(size < least)) continue;
      least = size;
      best = std::move(parts);
      found = tried;
    }
  step = found;
  return std::move(*best);
}

}  // namespace

MeshLevels decompose_grid_mesh(const MeshFaces& fine, GridView<const double> positions,
                               const Scheme& scheme, Boundaries boundaries, ReverseMode mode,
                               int levels) {
  if (levels < 0)
    throw InvalidField("levels = " + std::to_string(levels) + " is negative; give 0 or more");
  if (positions.rows() != fine.vertices || positions.cols() != 3)
    throw InvalidField("there are " + std::to_string(positions.rows()) + " positions for " +
                       std::to_string(fine.vertices) + " vertices");
  const GridPatch patch = grid_of(fine, positions);
  GridStep step{scheme,
                {along(boundaries.x, patch.wraps_cols), along(boundaries.y, patch.wraps_rows)},
                patch.extent,
                patch.mirrored};
  std::vector<Index> vertices(patch.vertices.begin(), patch.vertices.end());
  MeshLevels found;
  for (int level = 0; level < levels; ++level) {
    try {
      if (found.empty()) {
        found.push_back(best_of_phases(fine, vertices, positions, step, mode, true));
        continue;
      }
      const auto& last = found.back();
      step = step.coarser();
      vertices.resize(static_cast<std::size_t>(last.mesh.coarse.vertices));
      for (std::size_t v = 0; v < vertices.size(); ++v) vertices[v] = static_cast<Index>(v);
      found.push_back(
          best_of_phases(last.mesh.coarse, vertices, last.coarse.view(), step, mode, false));
    } catch (const InvalidField& error) {
      if (found.empty()) throw;
      throw InvalidField("only " + std::to_string(level) + " of " + std::to_string(levels) +
                         " levels can be undone; after that " + error.what());
    }
  }
  return found;
}

}  // namespace arete
