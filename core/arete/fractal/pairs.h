// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "arete/algebra/fraction.h"
#include "arete/fractal/matrix_set.h"

namespace arete {

/// The matrix pairs that have a name, over any coefficient ring (Kotarski, Gdawiec, "Proste i
/// odwrotne schematy podzialu"; where the paper's print is wrong, corrected). Rows of L and R are
/// the control points of the left and of the right half. None of these checks its arguments.

/// Rows and columns reversed: R from L for a curve that does not care which end it starts from.
template <class R>
[[nodiscard]] Matrix<R> reversed(const Matrix<R>& a) {
  Matrix<R> result(a.rows(), a.cols());
  for (int i = 0; i < a.rows(); ++i)
    for (int j = 0; j < a.cols(); ++j) result(i, j) = a(a.rows() - 1 - i, a.cols() - 1 - j);
  return result;
}

template <class R>
[[nodiscard]] Matrix<R> matrix_of_rows(const std::vector<std::vector<R>>& rows) {
  Matrix<R> result(static_cast<int>(rows.size()),
                   rows.empty() ? 0 : static_cast<int>(rows.front().size()));
  for (int i = 0; i < result.rows(); ++i)
    for (int j = 0; j < result.cols(); ++j)
      result(i, j) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  return result;
}

/// Corner cutting of three points with ratios u : 1-u-v : v. Spectra {1, 1-u-v, u} and {1, 1-u-v,
/// v}. u = v = 1/4 is Chaikin's curve, 1/3 de Rham's. It converges for u, v >= 0, 0 < u + v < 1;
/// for u + v = 1 only to the segment between the two division points (u = v = 1/2 is not the
/// quadratic Bezier curve). Equal to the arc matrices of the scheme corner-cutting:u=..,v=...
template <class R>
[[nodiscard]] MatrixPair<R> corner_cutting_pair(const R& u, const R& v) {
  const R zero(0);
  const R one(1);
  return {matrix_of_rows<R>({{one - u, u, zero}, {v, one - v, zero}, {zero, one - u, u}}),
          matrix_of_rows<R>({{v, one - v, zero}, {zero, one - u, u}, {zero, v, one - v}})};
}

/// De Casteljau's algorithm at the middle: L_ij = C(i,j)/2^i on degree + 1 points, eigenvalues
/// 1, 1/2, ..., 2^-degree. degree >= 0; degree 0 is a point.
template <class R>
[[nodiscard]] MatrixPair<R> bezier_pair(int degree) {
  const R half = fraction<R>(1, 2);
  Matrix<R> left(degree + 1, degree + 1);
  left(0, 0) = R(1);
  for (int i = 1; i <= degree; ++i)
    for (int j = 0; j <= i; ++j)
      left(i, j) = (left(i - 1, j) + (j > 0 ? left(i - 1, j - 1) : R(0))) * half;
  Matrix<R> right = reversed(left);
  return {std::move(left), std::move(right)};
}

/// The fractal curve that the paper gets by disturbing the cubic Bezier pair. Printed with 0.51 in
/// the last row of L, which then sums to 1.1 and breaks affine invariance; 0.41 is the reading that
/// sums to 1 with 0.08 + 0.42 = 0.41 + 0.09 = 1/2. Spectra {1, 0.74, 0.5, -0.41} and {1, 0.5,
/// -0.42, 0.26}; the joint spectral radius of the differences is 0.74, so the curve is continuous
/// with Hoelder exponent 0.434.
template <class R>
[[nodiscard]] MatrixPair<R> perturbed_bezier_pair() {
  const R zero(0);
  const R half = fraction<R>(1, 2);
  const std::vector<R> middle{fraction<R>(8, 100), fraction<R>(42, 100), fraction<R>(41, 100),
                              fraction<R>(9, 100)};
  return {matrix_of_rows<R>({{R(1), zero, zero, zero},
                             {fraction<R>(26, 100), fraction<R>(74, 100), zero, zero},
                             {half, zero, zero, half},
                             middle}),
          matrix_of_rows<R>({middle,
                             {half, zero, zero, half},
                             {zero, zero, fraction<R>(26, 100), fraction<R>(74, 100)},
                             {zero, zero, zero, R(1)}})};
}

/// One step of the cubic B-spline on `intervals` >= 1 intervals with natural ends (control points
/// p_0..p_n, p_{-1} = 2 p_0 - p_1): the new points q_0 = p_0, q_2i = (1,6,1)/8, q_2i+1 = (1,1)/2,
/// q_2n = p_n cut into q_0..q_n and q_n..q_2n. The paper prints intervals = 4, the 5 x 5 pair.
/// Spectrum of L: {1, 1/2, 1/8, 0, ...}.
///
/// ONE step only: the paper's claim that iterating this pair generates the natural spline is false
/// for more than one interval. The halves take the cut q_n for an end of their own and keep it,
/// where the spline smooths it: for the printed example the iterated pair passes through 159/56
/// in the middle, the spline through 3. Iterated, the spline's arcs are those of four control
/// points, `natural-spline` in curve_system.h.
template <class R>
[[nodiscard]] MatrixPair<R> cubic_spline_pair(int intervals) {
  const int n = intervals + 1;
  Matrix<R> both(2 * intervals + 1, n);
  for (int k = 0; k <= 2 * intervals; ++k) {
    const int i = k / 2;
    if (k % 2 != 0) {
      both(k, i) = both(k, i + 1) = fraction<R>(1, 2);
    } else if (k == 0 || k == 2 * intervals) {
      both(k, i) = R(1);
    } else {
      both(k, i - 1) = both(k, i + 1) = fraction<R>(1, 8);
      both(k, i) = fraction<R>(3, 4);
    }
  }
  MatrixPair<R> pair{Matrix<R>(n, n), Matrix<R>(n, n)};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      pair.left(i, j) = both(i, j);
      pair.right(i, j) = both(intervals + i, j);
    }
  return pair;
}

}  // namespace arete
