// SPDX-License-Identifier: MIT
#pragma once

#include "arete/refine/refiner.h"

namespace arete {

struct CurveOptions {
  int levels = 1;
  /// The polygon is closed: index modulo its size, m^N n points. Otherwise `boundary` holds.
  bool closed = false;
  Boundary boundary = Boundary::extrapolate;
};

/// A refined polyline: one point a row, one coordinate a column.
template <class T>
struct Curve {
  Grid<T> points;
  /// Where point i lies among the control points: parameter.first + i parameter.spacing.
  AxisPlacement parameter;
};

/// Refines a polyline in any dimension: `points` holds one control point a row.
/// Open curves keep the points within the parameter range of the control points 0..n-1 (boundary
/// `none`: all that can be computed without ghost points, n -> 2n-5 for a 4-point rule).
/// \throws InvalidField for no points or coordinates, and as AxisPlan.
template <class T>
[[nodiscard]] Curve<T> refine_curve(GridView<const T> points, const Scheme& scheme,
                                    const CurveOptions& options = {});

}  // namespace arete
