// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "arete/algebra/matrix.h"
#include "arete/algebra/rational.h"

namespace arete {

/// The solution x of a x = b if there is exactly one, nothing if there is none or more than one.
/// a may have more rows than columns (every equation must hold).
///
/// Exact: rows are made integral and eliminated without fractions (Bareiss 1968), so the numbers
/// stay minors of the matrix. Cost O(rows cols^2) products of integers of about cols times the
/// size of the entries.
[[nodiscard]] inline std::optional<std::vector<Rational>> solve_unique(
    const Matrix<Rational>& a, const std::vector<Rational>& b) {
  const int rows = a.rows();
  const int cols = a.cols();
  Matrix<Integer> work(rows, cols + 1);
  for (int i = 0; i < rows; ++i) {
    Integer scale = boost::multiprecision::denominator(b[static_cast<std::size_t>(i)]);
    for (int j = 0; j < cols; ++j)
      scale = boost::multiprecision::lcm(scale, boost::multiprecision::denominator(a(i, j)));
    const auto integral = [&scale](const Rational& value) {
      return Integer(boost::multiprecision::numerator(value) *
                     (scale / boost::multiprecision::denominator(value)));
    };
    for (int j = 0; j < cols; ++j) work(i, j) = integral(a(i, j));
    work(i, cols) = integral(b[static_cast<std::size_t>(i)]);
  }

  Integer previous = 1;
  for (int k = 0; k < cols; ++k) {
    int pivot = k;
    while (pivot < rows && work(pivot, k) == 0) ++pivot;
    if (pivot == rows) return std::nullopt;  // rank below cols: not unique
    if (pivot != k)
      for (int j = 0; j <= cols; ++j) std::swap(work(pivot, j), work(k, j));
    for (int i = k + 1; i < rows; ++i) {
      for (int j = k + 1; j <= cols; ++j)
        work(i, j) = (work(k, k) * work(i, j) - work(i, k) * work(k, j)) / previous;
      work(i, k) = 0;
    }
    previous = work(k, k);
  }
  for (int i = cols; i < rows; ++i)
    if (work(i, cols) != 0) return std::nullopt;  // contradiction

  std::vector<Rational> x(static_cast<std::size_t>(cols), Rational(0));
  for (int i = cols - 1; i >= 0; --i) {
    Rational rest(work(i, cols));
    for (int j = i + 1; j < cols; ++j)
      rest -= Rational(work(i, j)) * x[static_cast<std::size_t>(j)];
    x[static_cast<std::size_t>(i)] = rest / Rational(work(i, i));
  }
  return x;
}

/// The rank of a rational matrix, exact (Bareiss elimination as above).
[[nodiscard]] inline int exact_rank(const Matrix<Rational>& a) {
  Integer scale = 1;
  for (int i = 0; i < a.rows(); ++i)
    for (int j = 0; j < a.cols(); ++j)
      scale = boost::multiprecision::lcm(scale, boost::multiprecision::denominator(a(i, j)));
  Matrix<Integer> work(a.rows(), a.cols());
  for (int i = 0; i < a.rows(); ++i)
    for (int j = 0; j < a.cols(); ++j)
      work(i, j) = boost::multiprecision::numerator(a(i, j)) *
                   (scale / boost::multiprecision::denominator(a(i, j)));
  int rank = 0;
  Integer previous = 1;
  for (int k = 0; k < a.cols() && rank < a.rows(); ++k) {
    int pivot = rank;
    while (pivot < a.rows() && work(pivot, k) == 0) ++pivot;
    if (pivot == a.rows()) continue;
    for (int j = 0; j < a.cols() && pivot != rank; ++j) std::swap(work(pivot, j), work(rank, j));
    for (int i = rank + 1; i < a.rows(); ++i) {
      for (int j = k + 1; j < a.cols(); ++j)
        work(i, j) = (work(rank, k) * work(i, j) - work(i, k) * work(rank, j)) / previous;
      work(i, k) = 0;
    }
    previous = work(rank, k);
    ++rank;
  }
  return rank;
}

}  // namespace arete
