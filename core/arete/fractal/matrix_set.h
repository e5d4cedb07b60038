// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "arete/algebra/matrix.h"
#include "arete/algebra/rational.h"
#include "arete/scheme/error.h"

namespace arete {

/// The m square matrices A_0..A_{m-1} by which the n control points of one arc become the control
/// points of its m sub-arcs, in the order of the curve: P -> A_0 P, ..., A_{m-1} P, points as rows.
///
/// An arc is addressed by the sub-arcs taken, coarsest first: address w_1..w_k stands for
/// A_{w_k} ... A_{w_1} P. As an iterated function system (Goldman 2004) the same matrices act on
/// barycentric rows from the right, in which case the map applied last is the coarsest.
template <class R>
struct MatrixSet {
  std::vector<Matrix<R>> maps;

  /// m, the number of sub-arcs.
  [[nodiscard]] int arity() const { return static_cast<int>(maps.size()); }
  /// n, the number of control points of an arc.
  [[nodiscard]] int size() const { return maps.empty() ? 0 : maps.front().rows(); }
  [[nodiscard]] const Matrix<R>& operator[](int i) const {
    return maps[static_cast<std::size_t>(i)];
  }
  [[nodiscard]] friend bool operator==(const MatrixSet&, const MatrixSet&) = default;
};

/// The case of two halves: L makes the left one, R the right one.
template <class R>
struct MatrixPair {
  Matrix<R> left;
  Matrix<R> right;

  operator MatrixSet<R>() const { return {{left, right}}; }  // NOLINT: a pair is a set
  [[nodiscard]] friend bool operator==(const MatrixPair&, const MatrixPair&) = default;
};

/// The sum of every row. Markov's condition, all ones, is what makes a curve move along when its
/// control points are moved together (affine invariance); entries may well be negative.
template <class R>
[[nodiscard]] std::vector<R> row_sums(const Matrix<R>& a) {
  std::vector<R> sums;
  for (int i = 0; i < a.rows(); ++i) {
    R sum(0);
    for (int j = 0; j < a.cols(); ++j) sum = sum + a(i, j);
    sums.push_back(sum);
  }
  return sums;
}

/// Whether every row sums to 1: exactly, in floating point to 1e-12.
template <class R>
[[nodiscard]] bool rows_sum_to_one(const Matrix<R>& a) {
  for (const R& sum : row_sums(a)) {
    if constexpr (std::is_floating_point_v<R>) {
      if (!(std::abs(sum - 1) <= R(1e-12))) return false;
    } else if (!(sum == R(1))) {
      return false;
    }
  }
  return true;
}

/// Whether it is a Markov matrix in the narrow sense: rows sum to 1 and no entry is negative. Then
/// every sub-arc's points are averages, and the curve stays in the convex hull.
template <class R>
[[nodiscard]] bool is_stochastic(const Matrix<R>& a) {
  for (int i = 0; i < a.rows(); ++i)
    for (int j = 0; j < a.cols(); ++j)
      if (a(i, j) < R(0)) return false;
  return rows_sum_to_one(a);
}

/// \throws InvalidScheme unless there are at least two maps, all n x n with n >= 1, whose rows sum
/// to 1.
template <class R>
void check_maps(const MatrixSet<R>& set) {
  if (set.arity() < 2)
    throw InvalidScheme(
        "a set of matrices needs at least two of them, one for each part of an arc");
  for (int i = 0; i < set.arity(); ++i) {
    const std::string which = "matrix " + std::to_string(i);
    if (set[i].rows() != set.size() || set[i].cols() != set.size() || set.size() < 1)
      throw InvalidScheme(which + " is " + std::to_string(set[i].rows()) + " x " +
                          std::to_string(set[i].cols()) + " where " + std::to_string(set.size()) +
                          " control points need a square one of that size");
    if (!rows_sum_to_one(set[i]))
      throw InvalidScheme(which +
                          " has a row that does not sum to 1, so that the curve would not "
                          "follow its control points; correct that row");
  }
}

/// The same numbers, rounded.
[[nodiscard]] inline Matrix<double> to_double(const Matrix<Rational>& a) {
  Matrix<double> result(a.rows(), a.cols());
  for (int i = 0; i < a.rows(); ++i)
    for (int j = 0; j < a.cols(); ++j) result(i, j) = to_double(a(i, j));
  return result;
}

[[nodiscard]] inline MatrixSet<double> to_double(const MatrixSet<Rational>& set) {
  MatrixSet<double> result;
  for (const Matrix<Rational>& map : set.maps) result.maps.push_back(to_double(map));
  return result;
}

}  // namespace arete
