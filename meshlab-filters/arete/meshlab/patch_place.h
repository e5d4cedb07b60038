// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "arete/meshlab/axis_samples.h"
#include "arete/meshlab/mesh_arrays.h"
#include "arete/topology/grid_patch.h"

namespace arete::meshlab {

/// A place on a grid patch: along its columns (row) and along its rows (col).
struct PatchPlace {
  AxisSample row;
  AxisSample col;
};

/// The row or column after one that begins a cell.
[[nodiscard]] inline Index following(Index i, Index count) { return i + 1 < count ? i + 1 : 0; }

/// The vertices of a cell: north-west, north-east, south-east, south-west.
[[nodiscard]] inline std::array<int, 4> cell_corners(const GridPatch& patch, Index row, Index col) {
  const Index down = following(row, patch.extent.rows);
  const Index right = following(col, patch.extent.cols);
  return {patch.vertex(row, col), patch.vertex(row, right), patch.vertex(down, right),
          patch.vertex(down, col)};
}

// Equal numbers stay what they are, so that straight rows of vertices stay straight.
[[nodiscard]] inline double mixed(double a, double b, double t) {
  return t == 0 || a == b ? a : (1 - t) * a + t * b;
}

/// The bilinear blend of a number of the vertices at a place; exactly the number of a vertex at its
/// place. Beyond the rim the last cell goes on.
[[nodiscard]] double blended(const GridPatch& patch, const auto& value, const PatchPlace& place) {
  const AxisSample &y = place.row, &x = place.col;
  const Index right = following(x.cell, patch.extent.cols);
  const auto along = [&](Index row) {
    return mixed(value(patch.vertex(row, x.cell)), value(patch.vertex(row, right)), x.t);
  };
  if (y.t == 0) return along(y.cell);
  return mixed(along(y.cell), along(following(y.cell, patch.extent.rows)), y.t);
}

/// The vertex nearest to a place.
[[nodiscard]] inline int nearest_vertex(const GridPatch& patch, const PatchPlace& place) {
  const auto nearest = [](const AxisSample& sample, Index count) {
    return sample.t < 0.5 ? sample.cell : following(sample.cell, count);
  };
  return patch.vertex(nearest(place.row, patch.extent.rows), nearest(place.col, patch.extent.cols));
}

/// The number of a channel at a place.
[[nodiscard]] inline float carried(const GridPatch& patch, const Channel& channel,
                                   PatchPlace place) {
  const auto value = [&](int v) -> double { return channel.values[static_cast<std::size_t>(v)]; };
  if (channel.blend == Blend::nearest)
    return static_cast<float>(value(nearest_vertex(patch, place)));
  if (channel.blend == Blend::within) {
    place.row.t = std::clamp(place.row.t, 0.0, 1.0);
    place.col.t = std::clamp(place.col.t, 0.0, 1.0);
  }
  return static_cast<float>(blended(patch, value, place));
}

}  // namespace arete::meshlab
