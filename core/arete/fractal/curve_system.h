// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "arete/field/error.h"
#include "arete/fractal/matrix_set.h"

namespace arete {

/// A way to make a curve of arcs out of a control polygon: the matrices of an arc, and how the
/// polygon is cut into the control points of its arcs.
struct CurveSystem {
  std::string text;  ///< as parsed; parse_curve_system(text, count) gives the same again
  MatrixSet<Rational> set;
  /// Arc k begins at control point k * step.
  int step = 1;
  /// The polygon is a contour: arc i is the quadratic Bezier arc (m_i-1, c_i, m_i), m_i the middle
  /// of the edge from c_i to c_i+1. Always closed.
  bool contour = false;
  /// A ghost point 2 p_0 - p_1 is put before the first point and one after the last; such a curve
  /// has two ends and cannot be closed.
  bool natural_ends = false;
};

/// Reads, for a polygon of `count` control points,
/// - `bezier` (one curve through all, degree count - 1) or `bezier:degree=D` (a chain of curves
///   that share their end points, count = k D + 1 points; closed: k D);
/// - `perturbed-bezier`: a chain of fractal arcs of four points each (3 k + 1; closed: 3 k);
/// - `natural-spline`: the cubic B-spline with natural ends on at least 2 points, one arc between
///   neighbours. The points control it; to pass through them solve first
///   (variational/natural_spline.h);
/// - `contour`: a closed C^1 chain of quadratic arcs about a closed polygon of at least 3 points,
///   each arc a system of two maps of its own: N, 2N, 4N, ... points on the curve at every depth;
/// - any scheme of the catalogue: every window of consecutive points is an arc.
/// \throws InvalidScheme for a text that names nothing, or a degree outside 1..64.
/// \throws InvalidField if count does not fit; the message says what would.
[[nodiscard]] CurveSystem parse_curve_system(std::string_view text, int count);

/// The control points of every arc, in the order of the curve.
/// \throws InvalidField if the number of points does not fit, or for a system that cannot close.
template <class R>
[[nodiscard]] std::vector<Matrix<R>> cut_into_arcs(const CurveSystem& system,
                                                   const Matrix<R>& control, bool closed);

/// How many arcs `count` points make; checks as above.
[[nodiscard]] int arc_count(const CurveSystem& system, int count, bool closed);

/// The quadratic arcs of a closed polygon (see `contour`): a reverse-Chaikin polygon is the contour
/// as so many systems of two maps. \throws InvalidField for fewer than 3 points.
template <class R>
[[nodiscard]] std::vector<Matrix<R>> contour_arcs(const Matrix<R>& polygon);

template <class R>
std::vector<Matrix<R>> cut_into_arcs(const CurveSystem& system, const Matrix<R>& control,
                                     bool closed) {
  if (system.contour) return contour_arcs(control);
  std::vector<Matrix<R>> arcs;
  const int n = control.rows();
  const int count = arc_count(system, n, closed);
  const int origin = system.natural_ends ? -1 : 0;
  for (int k = 0; k < count; ++k) {
    Matrix<R> arc(system.set.size(), control.cols());
    for (int i = 0; i < arc.rows(); ++i)
      for (int c = 0; c < arc.cols(); ++c) {
        const int index = k * system.step + i + origin;
        if (index < 0)
          arc(i, c) = R(2) * control(0, c) - control(1, c);
        else if (system.natural_ends && index == n)
          arc(i, c) = R(2) * control(n - 1, c) - control(n - 2, c);
        else
          arc(i, c) = control(index % n, c);
      }
    arcs.push_back(std::move(arc));
  }
  return arcs;
}

template <class R>
std::vector<Matrix<R>> contour_arcs(const Matrix<R>& polygon) {
  const int n = polygon.rows();
  if (n < 3) throw InvalidField("a contour needs at least 3 points, not " + std::to_string(n));
  std::vector<Matrix<R>> arcs;
  for (int i = 0; i < n; ++i) {
    Matrix<R> arc(3, polygon.cols());
    for (int c = 0; c < polygon.cols(); ++c) {
      const R& here = polygon(i, c);
      arc(0, c) = (polygon((i + n - 1) % n, c) + here) / R(2);
      arc(1, c) = here;
      arc(2, c) = (here + polygon((i + 1) % n, c)) / R(2);
    }
    arcs.push_back(std::move(arc));
  }
  return arcs;
}

}  // namespace arete
