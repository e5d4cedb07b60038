// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "arete/field/boundary.h"
#include "arete/scheme/scheme.h"

namespace arete::cli {

struct CurveRequest {
  int levels = 1;
  Boundary boundary = Boundary::extrapolate;  ///< periodic: the polygon is closed
  bool limit = false;      ///< points of the limit curve; tangents and curvature are always there
  bool tangents = false;   ///< derivatives by the parameter (1 from control point to control point)
  bool curvature = false;  ///< of the limit curve
  bool fixed_ends = false;  ///< the first and the last control point begin and end the result
};

/// One refined curve, all by points.
struct CurveSamples {
  Grid<double> points;
  std::vector<double> tau;        ///< parameters among the control points 0, 1, ...
  Grid<double> tangents;          ///< as many columns as points, or empty
  std::vector<double> curvature;  ///< signed in the plane (left turns positive), or empty
};

/// Refines a polyline with what is asked for.
/// \throws Misuse where the limit, its derivative or second derivative is not certified to exist,
/// for fixed ends of a closed curve or together with boundary none, and for curvature of a curve
/// with one coordinate. \throws InvalidField see AxisPlan.
[[nodiscard]] CurveSamples sample_curve(const Grid<double>& control, const Scheme& scheme,
                                        const CurveRequest& request);

/// Curvature from first and second derivatives: signed in the plane, |r' x r''|/|r'|^3 in any other
/// dimension; NaN where r' = 0.
[[nodiscard]] std::vector<double> curvature_of(const Grid<double>& first,
                                               const Grid<double>& second);

}  // namespace arete::cli
