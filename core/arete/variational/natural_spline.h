// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "arete/algebra/fraction.h"
#include "arete/algebra/matrix.h"
#include "arete/field/error.h"
#include "arete/variational/banded.h"

namespace arete {

/// What a cubic spline does at its ends.
enum class SplineEnds {
  natural,  ///< second derivative 0: of all curves through the points the least bending energy
  closed    ///< joins its beginning twice differentiably; the last point is not repeated
};

/// The cubic spline F of one parameter through points v_0..v_n of any dimension at the knots
/// 0, 1, ..., n: cubic between knots, twice continuously differentiable, F'' = 0 at the ends.
/// Among all curves through the points it has the least bending energy, the integral of |F''|^2
/// (F'''' = 0 between knots).
///
/// It is the limit of subdivision: with control points p = C^-1 v, C = tridiagonal (1, 4, 1)/6
/// whose first and last rows are (1, 0, ...) and (..., 0, 1),
///
///     q_0 = p_0,  q_2i = (p_{i-1} + 6 p_i + p_{i+1})/8,  q_2i+1 = (p_i + p_{i+1})/2,  q_2n = p_n,
///
/// whose matrices are cubic_spline_pair (fractal/pairs.h). The ghost points are p_{-1} = 2p_0 -
/// p_1. (Warren, Weimer, "Subdivision Methods for Geometric Design", 2002, for the variational
/// view; Kotarski, Gdawiec, "Proste i odwrotne schematy podzialu".)
///
/// One point is a constant, two are a segment. R is any field: exact rationals or double. Cost
/// O(n).
template <class R>
class NaturalSpline {
 public:
  /// One point a row. \throws InvalidField without points or coordinates.
  explicit NaturalSpline(const Matrix<R>& points, SplineEnds ends = SplineEnds::natural)
      : ends_(ends), control_(points) {
    if (points.rows() < 1 || points.cols() < 1)
      throw InvalidField("a spline needs at least one point with at least one coordinate");
    solve();
  }

  /// p, one point a row.
  [[nodiscard]] const Matrix<R>& control() const { return control_; }
  [[nodiscard]] SplineEnds ends() const { return ends_; }

  /// The control polygon after so many steps: 2^levels n + 1 points (closed: 2^levels n).
  [[nodiscard]] Matrix<R> refined(int levels) const {
    Matrix<R> level = control_;
    for (int step = 0; step < levels; ++step) level = refined_once(level);
    return level;
  }

  /// Points of the spline itself: F(i/2^levels) for all i in the range of the knots.
  [[nodiscard]] Matrix<R> points(int levels) const {
    const Matrix<R> level = refined(levels);
    return mapped(level, [&](int i, int c) { return limit(level, i, c); });
  }

  /// F'(i/2^levels), by the unit of the parameter.
  [[nodiscard]] Matrix<R> derivatives(int levels) const {
    const Matrix<R> level = refined(levels);
    const R scale = scale_of(levels) / R(2);
    return mapped(level, [&](int i, int c) {
      return (ghost(level, i + 1, c) - ghost(level, i - 1, c)) * scale;
    });
  }

  /// F''(i/2^levels).
  [[nodiscard]] Matrix<R> second_derivatives(int levels) const {
    const Matrix<R> level = refined(levels);
    const R scale = scale_of(levels) * scale_of(levels);
    return mapped(level, [&](int i, int c) { return second_difference(level, i, c) * scale; });
  }

  /// F(knot + t), 0 <= t <= 1, 0 <= knot < number of pieces.
  [[nodiscard]] std::vector<R> value(int knot, const R& t) const {
    const R s = R(1) - t;
    const R sixth = fraction<R>(1, 6);
    std::vector<R> point;
    for (int c = 0; c < control_.cols(); ++c)
      point.push_back((s * s * s * ghost(control_, knot - 1, c) +
                       (R(4) - R(6) * t * t + R(3) * t * t * t) * ghost(control_, knot, c) +
                       (R(4) - R(6) * s * s + R(3) * s * s * s) * ghost(control_, knot + 1, c) +
                       t * t * t * ghost(control_, knot + 2, c)) *
                      sixth);
    return point;
  }

  /// The integral of |F''|^2, all coordinates together: with m_i the second differences of p (0 at
  /// the ends), sum (m_i^2 + m_i m_{i+1} + m_{i+1}^2)/3.
  [[nodiscard]] R bending_energy() const {
    R energy(0);
    const int pieces = ends_ == SplineEnds::closed ? control_.rows() : control_.rows() - 1;
    for (int c = 0; c < control_.cols(); ++c)
      for (int i = 0; i < pieces; ++i) {
        const R a = second_difference(control_, i, c);
        const R b = second_difference(control_, i + 1, c);
        energy = energy + (a * a + a * b + b * b) * fraction<R>(1, 3);
      }
    return energy;
  }

 private:
  [[nodiscard]] R ghost(const Matrix<R>& level, int i, int c) const {
    const int n = level.rows();
    if (ends_ == SplineEnds::closed) return level(((i % n) + n) % n, c);
    if (n == 1) return level(0, c);
    if (i < 0) return level(0, c) + R(-i) * (level(0, c) - level(1, c));
    if (i >= n) return level(n - 1, c) + R(i - n + 1) * (level(n - 1, c) - level(n - 2, c));
    return level(i, c);
  }

  [[nodiscard]] R second_difference(const Matrix<R>& level, int i, int c) const {
    return ghost(level, i - 1, c) - R(2) * ghost(level, i, c) + ghost(level, i + 1, c);
  }

  [[nodiscard]] R limit(const Matrix<R>& level, int i, int c) const {
    return (ghost(level, i - 1, c) + R(4) * ghost(level, i, c) + ghost(level, i + 1, c)) *
           fraction<R>(1, 6);
  }

  [[nodiscard]] static R scale_of(int levels) {
    R scale(1);
    for (int step = 0; step < levels; ++step) scale = scale * R(2);
    return scale;
  }

  template <class F>
  [[nodiscard]] static Matrix<R> mapped(const Matrix<R>& level, F&& entry) {
    Matrix<R> result(level.rows(), level.cols());
    for (int i = 0; i < level.rows(); ++i)
      for (int c = 0; c < level.cols(); ++c) result(i, c) = entry(i, c);
    return result;
  }

  [[nodiscard]] Matrix<R> refined_once(const Matrix<R>& level) const {
    const int n = level.rows();
    Matrix<R> fine(ends_ == SplineEnds::closed ? 2 * n : 2 * n - 1, level.cols());
    for (int k = 0; k < fine.rows(); ++k)
      for (int c = 0; c < fine.cols(); ++c) {
        const int i = k / 2;
        fine(k, c) = k % 2 == 0
                         ? (ghost(level, i - 1, c) + R(6) * level(i, c) + ghost(level, i + 1, c)) *
                               fraction<R>(1, 8)
                         : (level(i, c) + ghost(level, i + 1, c)) * fraction<R>(1, 2);
      }
    return fine;
  }

  void solve();

  SplineEnds ends_;
  Matrix<R> control_;
};

/// C, the limits at the knots by the control points; rows 0 and n are unit rows. For documentation
/// and tests: the solver never makes it.
template <class R>
[[nodiscard]] Matrix<R> natural_spline_matrix(int intervals) {
  Matrix<R> c(intervals + 1, intervals + 1);
  c(0, 0) = c(intervals, intervals) = R(1);
  for (int i = 1; i < intervals; ++i) {
    c(i, i - 1) = c(i, i + 1) = fraction<R>(1, 6);
    c(i, i) = fraction<R>(2, 3);
  }
  return c;
}

template <class R>
void NaturalSpline<R>::solve() {
  const int n = control_.rows();
  if (n == 1) return;
  const bool closed = ends_ == SplineEnds::closed;
  // A closed polygon is folded, 0, n-1, 1, n-2, ..., so that the cyclic band becomes a plain one.
  const auto place = [&](int i) -> Index {
    if (!closed) return i;
    const int wrapped = ((i % n) + n) % n;
    return 2 * wrapped < n ? 2 * wrapped : 2 * (n - 1 - wrapped) + 1;
  };
  BandedSystem<R> system(n, closed ? 2 : 1, closed ? 2 : 1);
  for (int i = 0; i < n; ++i) {
    if (!closed && (i == 0 || i == n - 1)) {
      system.at(i, i) = R(1);
      continue;
    }
    for (int offset = -1; offset <= 1; ++offset) {
      R& entry = system.at(place(i), place(i + offset));
      entry = entry + (offset == 0 ? fraction<R>(2, 3) : fraction<R>(1, 6));
    }
  }
  (void)system.factor();  // strictly diagonally dominant
  std::vector<R> column(static_cast<std::size_t>(n), R(0));
  for (int c = 0; c < control_.cols(); ++c) {
    for (int i = 0; i < n; ++i) column[static_cast<std::size_t>(place(i))] = control_(i, c);
    system.solve(column.data());
    for (int i = 0; i < n; ++i) control_(i, c) = column[static_cast<std::size_t>(place(i))];
  }
}

}  // namespace arete
