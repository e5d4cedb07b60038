// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "arete/field/boundary.h"
#include "arete/field/grid.h"
#include "arete/scheme/stencil.h"
#include "arete/variational/banded.h"

namespace arete {

/// Cardinal interpolation along one axis: the control points whose limit passes through given data,
///
///     sum_k w_k p_{i + first + k} = v_i,   i = 0..count-1,
///
/// w being the weights of the limit at the *position* of a sample: limit_stencil(mask) for primal
/// schemes (tau an integer, shifted by it), in general limit_stencil_at(mask, tau/(m-1))
/// (fractal/arc_matrices.h). Ghost samples are those of the boundary, so that refining the control
/// points with the same boundary gives a curve through the data. For the cubic B-spline and
/// `extrapolate` it is the natural cubic spline.
///
/// Interpolatory schemes have w = (1): the data are the control points.
///
/// Refused (InvalidField, with the reason):
/// - boundary `none`: fewer limit values than control points;
/// - w(z) = sum_k w_k z^k vanishes somewhere on |z| = 1 (decided exactly): waves of that length
/// have
///   limit 0, the data cannot say how much of them to take, and the answer at one place would
///   depend on data at any distance. On an axis with a fitting number of samples the system is
///   singular;
/// - the system is singular for this number of samples and boundary (a zero pivot), or so nearly so
///   that data of size 1 would need control points above largest_growth (floating point only).
///
/// R is Rational (exact) or double. Cost: a banded factorisation, once; O(count band) a line.
template <class R>
class CardinalAxis {
 public:
  static constexpr double largest_growth = 1e8;

  /// \throws InvalidField as above, and for count < 1 or a stencil without weights.
  CardinalAxis(const Stencil& limit, Boundary boundary, Index count)
      : CardinalAxis(limit, boundary, boundary, count) {}
  /// Another boundary before the first sample than after the last; periodic: both.
  CardinalAxis(const Stencil& limit, Boundary before, Boundary after, Index count);

  [[nodiscard]] Index count() const { return count_; }
  /// Whether data and control points are the same.
  [[nodiscard]] bool trivial() const { return !system_; }

  /// Data to control points, in place. Thread-safe.
  void solve(R* values) const { solve_lines(values, 1, 1); }
  /// `width` axes side by side: sample i of axis c is values[i * stride + c].
  void solve_lines(R* values, Index width, Index stride) const;

 private:
  [[nodiscard]] Index place(Index i) const;
  void check_growth(const Stencil& limit) const;

  Index count_;
  bool folded_;
  std::optional<BandedSystem<R>> system_;
};

/// How far an influence reaches along an unbounded axis: the smallest h such that data further than
/// h samples away change a control point by less than `tolerance` times the largest of them.
/// 1.3 samples a decimal digit for the cubic B-spline (2 - sqrt(3) = 0.268 a sample): 28 at 2^-53.
/// \throws InvalidField as CardinalAxis.
[[nodiscard]] Index cardinal_reach(const Stencil& limit, double tolerance = 0x1p-53);

/// The control grid whose limit surface passes through the samples: both axes, one after the other
/// (in either order), in double, rounded to T at the end. For rasters larger than memory see
/// cardinal_source.h. \throws InvalidField as CardinalAxis, and for a sample that is not finite:
/// holes have no control points (fill them first, or refine without interpolation).
template <class T>
[[nodiscard]] Grid<T> cardinal_control(GridView<const T> samples, const Stencil& limit_x,
                                       const Stencil& limit_y, const Boundaries& boundaries);

}  // namespace arete
