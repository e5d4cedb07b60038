// SPDX-License-Identifier: MIT
#include "arete/reverse/grid_step.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "arete/reverse/grid_reverse.h"
#include "arete/reverse/synthesis_rows.h"
#include "arete/topology/grid_faces.h"

namespace arete {
namespace {

Index coarse_count(const GridStep& step, Index count, Boundary boundary) {
  const Index coarse = ReverseLevel(step.scheme.mask(), count, boundary).coarse_count;
  const Index least = boundary == Boundary::periodic ? 3 : 2;
  if (coarse < least || coarse >= count)
    throw InvalidField("an axis of " + std::to_string(count) + " vertices would have " +
                       std::to_string(coarse) + "; a grid needs " + std::to_string(least) +
                       " or more, and fewer than before: take fewer levels");
  return coarse;
}

// For every coarse sample of an axis the nearest fine one, in ascending order and each once.
std::vector<Index> nearest(const GridStep& step, Index count, Boundary boundary) {
  const ReverseLevel level(step.scheme.mask(), count, boundary);
  const AxisPlacement place = level.placement();
  std::vector<Index> chosen;
  for (Index j = 0; j < level.coarse_count; ++j) {
    const double at = place.first + static_cast<double>(j) * place.spacing;
    const Index lowest = chosen.empty() ? 0 : chosen.back() + 1;
    chosen.push_back(
        std::clamp(static_cast<Index>(std::lround(at)), lowest, count - level.coarse_count + j));
  }
  return chosen;
}

MeshFaces faces_of(Extent extent, const GridStep& step) {
  return mesh_faces(extent.rows * extent.cols,
                    grid_faces(extent, step.mirrored, step.wraps_rows(), step.wraps_cols()));
}

void check_rows(Index rows, Extent extent) {
  if (rows != extent.rows * extent.cols)
    throw InvalidField("there are " + std::to_string(rows) + " positions where the grid has " +
                       std::to_string(extent.rows) + " x " + std::to_string(extent.cols) +
                       " vertices");
}

}  // namespace

Extent GridStep::coarse() const {
  return {coarse_count(*this, fine.rows, boundaries.y),
          coarse_count(*this, fine.cols, boundaries.x)};
}

MeshFaces GridStep::coarse_faces() const { return faces_of(coarse(), *this); }

MeshFaces GridStep::fine_faces() const {
  const std::vector<Index> from = order();
  std::vector<Index> number(from.size());
  for (std::size_t i = 0; i < from.size(); ++i)
    number[static_cast<std::size_t>(from[i])] = static_cast<Index>(i);
  MeshFaces faces = faces_of(fine, *this);
  for (auto& face : faces.faces)
    for (Index& v : face) v = number[static_cast<std::size_t>(v)];
  return faces;
}

std::vector<Index> GridStep::order() const {
  std::vector<Index> result;
  std::vector<std::uint8_t> taken(static_cast<std::size_t>(fine.rows * fine.cols), 0);
  const auto take = [&](Index vertex) {
    if (std::exchange(taken[static_cast<std::size_t>(vertex)], 1) == 0) result.push_back(vertex);
  };
  const std::vector<Index> cols = nearest(*this, fine.cols, boundaries.x);
  for (const Index r : nearest(*this, fine.rows, boundaries.y))
    for (const Index c : cols) take(r * fine.cols + c);
  for (Index v = 0; v < fine.rows * fine.cols; ++v) take(v);
  return result;
}

std::vector<Index> GridStep::corner_faces() const {
  const std::vector<Index> rows = nearest(*this, fine.rows, boundaries.y);
  const std::vector<Index> cols = nearest(*this, fine.cols, boundaries.x);
  // The first and the last fine cell between coarse sample j and the next one.
  const auto cells = [](const std::vector<Index>& at, std::size_t j, Index count) {
    return std::pair(at[j], (j + 1 < at.size() ? at[j + 1] : count) - 1);
  };
  const Index across = fine.cols - (wraps_cols() ? 0 : 1);
  std::vector<Index> faces;
  for (std::size_t i = 0; i + (wraps_rows() ? 0 : 1) < rows.size(); ++i)
    for (std::size_t j = 0; j + (wraps_cols() ? 0 : 1) < cols.size(); ++j) {
      const auto [top, bottom] = cells(rows, i, fine.rows);
      const auto [left, right] = cells(cols, j, fine.cols);
      const Index second = mirrored ? bottom * across + left : top * across + right;
      const Index last = mirrored ? top * across + right : bottom * across + left;
      faces.insert(faces.end(), {top * across + left, second, bottom * across + right, last});
    }
  return faces;
}

Grid<double> GridStep::subdivided(GridView<const double> coarse_positions) const {
  const Extent small = coarse();
  check_rows(coarse_positions.rows(), small);
  const Index lanes = coarse_positions.cols();
  const ReverseLevel down(scheme.mask(), fine.rows, boundaries.y);
  const ReverseLevel right(scheme.mask(), fine.cols, boundaries.x);
  const auto s_rows = synthesis_rows<double>(scheme.mask(), down, boundaries.y);
  const auto s_cols = synthesis_rows<double>(scheme.mask(), right, boundaries.x);
  Grid<double> tall({s_rows.rows(), small.cols * lanes});
  s_rows.multiply({coarse_positions.row(0), small.rows, small.cols * lanes,
                   small.cols * coarse_positions.stride()},
                  {tall.row(0), tall.rows(), tall.cols(), tall.cols()});
  // One row at a time: its columns one under the other. Samples that only pad a closed axis are
  // left out.
  Grid<double> wide({s_cols.rows(), lanes});
  Grid<double> positions({fine.rows * fine.cols, lanes});
  for (Index r = 0; r < fine.rows; ++r) {
    s_cols.multiply({tall.row(r), small.cols, lanes, lanes},
                    {wide.row(0), wide.rows(), lanes, lanes});
    std::copy_n(wide.row(0), fine.cols * lanes, positions.row(r * fine.cols));
  }
  Grid<double> ordered(positions.extent());
  const std::vector<Index> from = order();
  for (std::size_t i = 0; i < from.size(); ++i)
    std::copy_n(positions.row(from[i]), lanes, ordered.row(static_cast<Index>(i)));
  return ordered;
}

Grid<double> GridStep::reversed(GridView<const double> fine_positions, ReverseMode mode) const {
  check_rows(fine_positions.rows(), fine);
  const Extent small = coarse();
  GridReverseOptions options;
  options.mode = mode;
  options.boundaries = boundaries;
  const std::vector<Index> from = order();
  Grid<double> positions({small.rows * small.cols, fine_positions.cols()});
  Grid<double> samples(fine);
  for (Index c = 0; c < positions.cols(); ++c) {
    for (std::size_t i = 0; i < from.size(); ++i)
      samples.samples()[static_cast<std::size_t>(from[i])] =
          fine_positions(static_cast<Index>(i), c);
    const auto parts = decompose_grid<double>(std::as_const(samples).view(), scheme, options);
    for (Index v = 0; v < positions.rows(); ++v)
      positions(v, c) = parts.coarse.samples()[static_cast<std::size_t>(v)];
  }
  return positions;
}

}  // namespace arete
