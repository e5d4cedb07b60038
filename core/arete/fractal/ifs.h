// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "arete/field/error.h"
#include "arete/fractal/address.h"
#include "arete/fractal/matrix_set.h"

namespace arete {

/// One arc of a curve (or one patch) as an iterated function system, in barycentric form: n control
/// points P, one a row, in any dimension, and the matrices of its parts. The point of the address
/// w_1..w_k that starts from the barycentric row b (entries sum to 1) is
///
///     b A_{w_k} ... A_{w_1} P.
///
/// This is Goldman's system {P^-1 A P} (goldman.h) without its inverse, so it is right for every
/// control polygon: collinear, repeated, or a single point. With b = (1, 0, ..., 0) the points at
/// depth k are the first control points of the m^k arcs: for Bezier pairs they are on the curve,
/// for mask schemes they are the polygon after k steps, exactly. With b = fixed_row(A_0) they are
/// the starts of the arcs of the limit itself, at every depth.
///
/// Depth-first: memory is one control polygon a level, whatever the number of points.
template <class R>
class Ifs {
 public:
  /// Bound on m^depth.
  static constexpr long long largest_count = 1LL << 40;

  /// \throws InvalidScheme see check_maps. \throws InvalidField unless there are n control points
  /// with at least one coordinate.
  Ifs(MatrixSet<R> set, Matrix<R> control) : set_(std::move(set)), control_(std::move(control)) {
    check_maps(set_);
    if (control_.rows() != set_.size() || control_.cols() < 1)
      throw InvalidField("an arc of " + std::to_string(set_.size()) + " control points was given " +
                         std::to_string(control_.rows()) + " points of " +
                         std::to_string(control_.cols()) + " coordinates");
  }

  [[nodiscard]] const MatrixSet<R>& set() const { return set_; }
  [[nodiscard]] const Matrix<R>& control() const { return control_; }

  /// m^depth. \throws InvalidField for a negative depth or more than largest_count arcs.
  [[nodiscard]] long long count(int depth) const {
    if (depth < 0)
      throw InvalidField("depth " + std::to_string(depth) + " is negative; give 0 or more");
    long long arcs = 1;
    for (int level = 0; level < depth; ++level) {
      arcs *= set_.arity();
      if (arcs > largest_count)
        throw InvalidField("depth " + std::to_string(depth) +
                           " makes more than 2^40 arcs; use less");
    }
    return arcs;
  }

  /// The control points of the arc at the address.
  [[nodiscard]] Matrix<R> arc(const Address& address) const {
    Matrix<R> points = control_;
    for (const int digit : address) points = set_[digit] * points;
    return points;
  }

  /// visit(control points) for all m^depth arcs in the order of the curve.
  template <class Visit>
  void visit_arcs(int depth, Visit&& visit) const {
    (void)count(depth);
    descend(control_, depth, visit);
  }

  /// The deterministic algorithm: visit(point) for every arc in the order of the curve and every
  /// row of `seeds` (each a barycentric row of n entries); `point` holds the coordinates.
  template <class Visit>
  void visit_points(int depth, const Matrix<R>& seeds, Visit&& visit) const {
    if (seeds.cols() != set_.size())
      throw InvalidField("a starting point needs " + std::to_string(set_.size()) +
                         " barycentric weights, not " + std::to_string(seeds.cols()));
    std::vector<R> point(static_cast<std::size_t>(control_.cols()));
    visit_arcs(depth, [&](const Matrix<R>& arc) {
      for (int s = 0; s < seeds.rows(); ++s) {
        for (int c = 0; c < arc.cols(); ++c) {
          R sum(0);
          for (int i = 0; i < arc.rows(); ++i) sum = sum + seeds(s, i) * arc(i, c);
          point[static_cast<std::size_t>(c)] = sum;
        }
        visit(std::as_const(point));
      }
    });
  }

  /// The first control points of all arcs, one a row.
  [[nodiscard]] Matrix<R> points(int depth) const {
    if (count(depth) > (1 << 28))
      throw InvalidField("depth " + std::to_string(depth) +
                         " makes too many points to hold; visit them");
    Matrix<R> result(static_cast<int>(count(depth)), control_.cols());
    int row = 0;
    visit_arcs(depth, [&](const Matrix<R>& arc) {
      for (int c = 0; c < arc.cols(); ++c) result(row, c) = arc(0, c);
      ++row;
    });
    return result;
  }

 private:
  template <class Visit>
  void descend(const Matrix<R>& points, int depth, Visit& visit) const {
    if (depth == 0) {
      visit(points);
      return;
    }
    for (const Matrix<R>& map : set_.maps) descend(map * points, depth - 1, visit);
  }

  MatrixSet<R> set_;
  Matrix<R> control_;
};

/// The seed (1, 0, ..., 0): the first control point.
template <class R>
[[nodiscard]] Matrix<R> first_point_seed(int size) {
  Matrix<R> seed(1, size);
  seed(0, 0) = R(1);
  return seed;
}

}  // namespace arete
