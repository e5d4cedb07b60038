// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "arete/reverse/axis_reverse.h"
#include "arete/scheme/scheme.h"

namespace arete {

struct CurveReverseOptions {
  int levels = 1;
  ReverseMode mode = ReverseMode::least_squares;
  /// The polygon is closed: index modulo its size. Otherwise `boundary` says how it is continued.
  bool closed = false;
  Boundary boundary = Boundary::extrapolate;

  [[nodiscard]] Boundary axis() const { return closed ? Boundary::periodic : boundary; }
};

/// A polyline taken apart: a coarse one, and what has to be added at every level to come back.
template <class R>
struct Decomposition {
  Scheme scheme;
  CurveReverseOptions options;
  Grid<R> coarse;                ///< one point a row, one coordinate a column
  std::vector<Grid<R>> details;  ///< of step 1 (the finest), 2, ...: one vector a row
  std::vector<Index> sizes;      ///< point counts, the input's first: levels + 1 of them
  AxisPlacement placement;       ///< where the coarse points lie among the input's

  /// How many points and detail vectors are held: the input's count, and for closed polygons one
  /// more for every step that began with a count that the arity does not divide (times what was
  /// padded).
  [[nodiscard]] Index vectors() const {
    Index total = coarse.rows();
    for (const Grid<R>& level : details) total += level.rows();
    return total;
  }
};

/// Takes `levels` reverse steps. R is float, double or Rational (then everything is exact).
/// Steps on a single point change nothing.
/// \throws InvalidField for no points or coordinates, negative levels, boundary `none`; points
/// that are not finite are passed on as they are. \throws InvalidScheme see AxisReverse.
template <class R>
[[nodiscard]] Decomposition<R> decompose(GridView<const R> points, const Scheme& scheme,
                                         const CurveReverseOptions& options = {}) {
  if (points.rows() < 1 || points.cols() < 1)
    throw InvalidField("a curve needs at least one point with at least one coordinate");
  if (options.levels < 0)
    throw InvalidField("levels = " + std::to_string(options.levels) +
                       " is negative; give 0 or more");
  Decomposition<R> result{scheme, options,         Grid<R>(points.extent()),
                          {},     {points.rows()}, {points.rows(), 0, 1}};
  for (Index i = 0; i < points.rows(); ++i)
    std::copy_n(points.row(i), points.cols(), result.coarse.row(i));
  const Index lanes = points.cols();
  for (int step = 0; step < options.levels; ++step) {
    const Grid<R> fine = std::move(result.coarse);
    const AxisReverse<R> axis(scheme.mask(), fine.rows(), options.axis(), options.mode);
    result.coarse = Grid<R>({axis.coarse_count(), lanes});
    Grid<R> details({axis.detail_count(), lanes});
    axis.analyse({fine.row(0), fine.rows(), lanes, lanes},
                 {result.coarse.row(0), result.coarse.rows(), lanes, lanes},
                 {details.samples().data(), details.rows(), lanes, lanes});
    result.details.push_back(std::move(details));
    result.sizes.push_back(axis.coarse_count());
    result.placement = composed(result.placement, axis.level().placement());
  }
  return result;
}

/// Puts the coarsest `steps` levels back; all of them gives the input again (to a few rounding
/// errors; exactly over rationals, and in floating point for dyadic data and dyadic local filters).
/// \throws InvalidField if there are not that many levels or the parts' sizes do not fit together.
template <class R>
[[nodiscard]] Grid<R> reconstruct(const Decomposition<R>& parts, int steps) {
  if (steps < 0 || static_cast<std::size_t>(steps) > parts.details.size())
    throw InvalidField("there are " + std::to_string(parts.details.size()) +
                       " levels of details, not " + std::to_string(steps));
  Grid<R> points = parts.coarse;
  const Index lanes = points.cols();
  for (std::size_t step = parts.details.size(), done = 0; done < static_cast<std::size_t>(steps);
       ++done) {
    const Grid<R>& details = parts.details[--step];
    const AxisReverse<R> axis(parts.scheme.mask(), parts.sizes.at(step), parts.options.axis(),
                              parts.options.mode);
    if (points.rows() != axis.coarse_count() || details.rows() != axis.detail_count() ||
        details.cols() != lanes)
      throw InvalidField("the coarse points and details of step " + std::to_string(step + 1) +
                         " do not have the sizes of this decomposition");
    Grid<R> fine({axis.fine_count(), lanes});
    axis.synthesise({points.row(0), points.rows(), lanes, lanes},
                    {details.samples().data(), details.rows(), lanes, lanes},
                    {fine.row(0), fine.rows(), lanes, lanes});
    points = std::move(fine);
  }
  return points;
}

template <class R>
[[nodiscard]] Grid<R> reconstruct(const Decomposition<R>& parts) {
  return reconstruct(parts, static_cast<int>(parts.details.size()));
}

}  // namespace arete
