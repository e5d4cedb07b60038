// SPDX-License-Identifier: MIT
#include "arete/vtk/internal/reduce.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace arete::vtk {
namespace {

/// The blocks of one axis.
struct Blocks {
  Index length;  ///< samples in a block
  Index count;
  Index first;  ///< the first sample of the first block; what is left over is shared by both ends

  Blocks(Index samples, Index factor)
      : length(std::min(factor, samples / 2)),
        count(samples / length),
        first(samples % length / 2) {}

  [[nodiscard]] AxisPlacement placement() const {
    const auto spacing = static_cast<double>(length);
    return {count, static_cast<double>(first) + (spacing - 1) / 2, spacing};
  }
};

template <class T, class Value>
Grid<T> means(const Blocks& rows, const Blocks& cols, const Value& value) {
  Grid<T> result({rows.count, cols.count}, std::numeric_limits<T>::quiet_NaN());
  const Index area = rows.length * cols.length;
  for (Index r = 0; r < rows.count; ++r) {
    for (Index c = 0; c < cols.count; ++c) {
      double sum = 0;
      Index valid = 0;
      for (Index k = 0; k < area; ++k) {
        const double sample = value(rows.first + r * rows.length + k / cols.length,
                                    cols.first + c * cols.length + k % cols.length);
        if (!std::isfinite(sample)) continue;
        sum += sample;
        ++valid;
      }
      if (2 * valid >= area) result(r, c) = static_cast<T>(sum / static_cast<double>(valid));
    }
  }
  return result;
}

}  // namespace

ReducedSurface reduce(const Surface& surface, Index most) {
  const Extent extent = surface.extent();
  const Index longest = std::max(extent.rows, extent.cols);
  ReducedSurface reduced{.factor = (longest + most - 1) / most,
                         .rows = {extent.rows, 0, 1},
                         .cols = {extent.cols, 0, 1},
                         .surface = surface};
  if (reduced.factor == 1) return reduced;

  const Blocks rows(extent.rows, reduced.factor);
  const Blocks cols(extent.cols, reduced.factor);
  reduced.heights =
      means<double>(rows, cols, [&](Index r, Index c) { return surface.height(r, c); });
  reduced.surface.heights = std::as_const(reduced.heights).view();
  reduced.rows = rows.placement();
  reduced.cols = cols.placement();
  reduced.surface.georeference = refined(surface.georeference, reduced.rows, reduced.cols);
  if (surface.gradients) {
    reduced.dz_dx = means<float>(rows, cols, surface.gradients->dz_dx);
    reduced.dz_dy = means<float>(rows, cols, surface.gradients->dz_dy);
    reduced.surface.gradients.emplace(
        Gradients{std::as_const(reduced.dz_dx).view(), std::as_const(reduced.dz_dy).view()});
  }
  return reduced;
}

}  // namespace arete::vtk
