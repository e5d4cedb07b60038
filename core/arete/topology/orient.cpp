// SPDX-License-Identifier: MIT
#include "arete/topology/orient.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "arete/field/at.h"

namespace arete {
namespace {

GridPatch transposed(const GridPatch& patch) {
  GridPatch result = patch;
  std::swap(result.extent.rows, result.extent.cols);
  std::swap(result.wraps_rows, result.wraps_cols);
  result.mirrored = !patch.mirrored;
  for (Index r = 0; r < result.extent.rows; ++r)
    for (Index c = 0; c < result.extent.cols; ++c)
      result.vertices[at(r * result.extent.cols + c)] = patch.vertex(c, r);
  for (Index r = 0; r < result.cell_rows(); ++r) {
    for (Index c = 0; c < result.cell_cols(); ++c) {
      GridCell cell = patch.cell(c, r);
      // The triangle on the bottom edge of a main diagonal is now the one on the left edge.
      if (cell.diagonal == Diagonal::main) std::swap(cell.faces[0], cell.faces[1]);
      result.cells[at(r * result.cell_cols() + c)] = cell;
    }
  }
  return result;
}

// Column c of the result is column `start` + c of the patch, or `start` - c when reversed; an axis
// that does not wrap is only ever reversed as a whole.
GridPatch with_columns(const GridPatch& patch, Index start, bool reversed) {
  GridPatch result = patch;
  result.mirrored = patch.mirrored != reversed;
  const Index cols = patch.extent.cols;
  const auto old_column = [&](Index c) {
    return ((reversed ? start - c : start + c) + cols) % cols;
  };
  for (Index r = 0; r < patch.extent.rows; ++r)
    for (Index c = 0; c < cols; ++c)
      result.vertices[at(r * cols + c)] = patch.vertex(r, old_column(c));
  for (Index r = 0; r < patch.cell_rows(); ++r) {
    for (Index c = 0; c < patch.cell_cols(); ++c) {
      GridCell cell = patch.cell(r, reversed ? old_column(c + 1) : old_column(c));
      if (reversed && cell.diagonal != Diagonal::none)
        cell.diagonal = cell.diagonal == Diagonal::main ? Diagonal::anti : Diagonal::main;
      result.cells[at(r * patch.cell_cols() + c)] = cell;
    }
  }
  return result;
}

GridPatch with_rows(const GridPatch& patch, Index start, bool reversed) {
  return transposed(with_columns(transposed(patch), start, reversed));
}

struct Positions {
  const GridPatch& patch;
  std::span<const Point3> points;
  const Point3& operator()(Index r, Index c) const {
    const Extent e = patch.extent;
    return points[at(patch.vertex((r + e.rows) % e.rows, (c + e.cols) % e.cols))];
  }
};

struct Plan {
  double x = 0;
  double y = 0;
};

// Where four corners say a direction goes, seen from above, of length 1 (or 0).
Plan direction(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const Plan sum{(b[0] - a[0]) + (d[0] - c[0]), (b[1] - a[1]) + (d[1] - c[1])};
  const double length = std::hypot(sum.x, sum.y);
  return length > 0 ? Plan{sum.x / length, sum.y / length} : Plan{};
}

GridPatch oriented_sheet(const GridPatch& patch, std::span<const Point3> points) {
  const Positions p{patch, points};
  const Index bottom = patch.extent.rows - 1;
  const Index right = patch.extent.cols - 1;
  const Plan u = direction(p(0, 0), p(0, right), p(bottom, 0), p(bottom, right));
  const Plan v = direction(p(0, 0), p(bottom, 0), p(0, right), p(bottom, right));

  struct Choice {
    bool transpose, flip_rows, flip_cols;  // applied to the patch in the order flips, transpose
    double score;
    Point3 first, along, across;
  };
  std::vector<Choice> choices;
  for (bool transpose : {false, true}) {
    for (bool flip_rows : {false, true}) {
      for (bool flip_cols : {false, true}) {
        const double su = flip_cols ? -1 : 1;
        const double sv = flip_rows ? -1 : 1;
        const double score = transpose ? sv * v.x - su * u.y : su * u.x - sv * v.y;
        const Index r0 = flip_rows ? bottom : 0;
        const Index c0 = flip_cols ? right : 0;
        Point3 along = p(r0, right - c0);
        Point3 across = p(bottom - r0, c0);
        if (transpose) std::swap(along, across);
        choices.push_back({transpose, flip_rows, flip_cols, score, p(r0, c0), along, across});
      }
    }
  }
  const Choice best =
      *std::min_element(choices.begin(), choices.end(), [](const auto& a, const auto& b) {
        if (a.score != b.score) return a.score > b.score;
        return std::tie(a.first, a.along, a.across) < std::tie(b.first, b.along, b.across);
      });
  GridPatch result = patch;
  if (best.flip_cols) result = with_columns(result, right, true);
  if (best.flip_rows) result = with_rows(result, bottom, true);
  if (best.transpose) result = transposed(result);
  return result;
}

Index smallest_in_row(const Positions& p, Index r) {
  Index best = 0;
  for (Index c = 1; c < p.patch.extent.cols; ++c)
    if (p(r, c) < p(r, best)) best = c;
  return best;
}

GridPatch oriented_tube(GridPatch patch, std::span<const Point3> points) {
  if (!patch.wraps_cols) patch = transposed(patch);
  const Positions p{patch, points};
  const Index last = patch.extent.rows - 1;
  const bool flip = p(last, smallest_in_row(p, last)) < p(0, smallest_in_row(p, 0));
  const Index row = flip ? last : 0;
  const Index start = smallest_in_row(p, row);
  const bool reversed = p(row, start - 1) < p(row, start + 1);
  GridPatch result = with_columns(patch, start, reversed);
  return flip ? with_rows(result, last, true) : result;
}

GridPatch oriented_torus(GridPatch patch, std::span<const Point3> points) {
  Index row = 0;
  Index col = 0;
  {
    const Positions p{patch, points};
    for (Index r = 0; r < patch.extent.rows; ++r) {
      const Index c = smallest_in_row(p, r);
      if (p(r, c) < p(row, col)) {
        row = r;
        col = c;
      }
    }
    const Point3& along_row = std::min(p(row, col - 1), p(row, col + 1));
    const Point3& along_col = std::min(p(row - 1, col), p(row + 1, col));
    if (along_col < along_row) {
      patch = transposed(patch);
      std::swap(row, col);
    }
  }
  const Positions p{patch, points};
  const bool flip_cols = p(row, col - 1) < p(row, col + 1);
  const bool flip_rows = p(row - 1, col) < p(row + 1, col);
  return with_rows(with_columns(patch, col, flip_cols), row, flip_rows);
}

}  // namespace

GridPatch oriented(const GridPatch& patch, std::span<const Point3> positions) {
  if (patch.wraps_rows && patch.wraps_cols) return oriented_torus(patch, positions);
  if (patch.wraps_rows || patch.wraps_cols) return oriented_tube(patch, positions);
  return oriented_sheet(patch, positions);
}

}  // namespace arete
