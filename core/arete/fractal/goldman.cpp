// SPDX-License-Identifier: MIT
#include "arete/fractal/goldman.h"

#include <string>

#include "arete/algebra/linear_solve.h"
#include "arete/field/error.h"

namespace arete {
namespace {

// a with the column appended.
Matrix<Rational> with_column(const Matrix<Rational>& a, const std::vector<Rational>& column) {
  Matrix<Rational> result(a.rows(), a.cols() + 1);
  for (int i = 0; i < a.rows(); ++i) {
    for (int j = 0; j < a.cols(); ++j) result(i, j) = a(i, j);
    result(i, a.cols()) = column[static_cast<std::size_t>(i)];
  }
  return result;
}

// The matrix x with p x = b, for regular p: Gauss-Jordan elimination on rationals.
Matrix<Rational> solved(Matrix<Rational> p, Matrix<Rational> b) {
  const int n = p.rows();
  for (int k = 0; k < n; ++k) {
    int pivot = k;
    while (p(pivot, k) == 0) ++pivot;
    for (int j = 0; j < n; ++j) {
      std::swap(p(pivot, j), p(k, j));
      std::swap(b(pivot, j), b(k, j));
    }
    const Rational scale = 1 / p(k, k);
    for (int j = 0; j < n; ++j) {
      p(k, j) *= scale;
      b(k, j) *= scale;
    }
    for (int i = 0; i < n; ++i) {
      const Rational factor = p(i, k);
      if (i == k || factor == 0) continue;
      for (int j = 0; j < n; ++j) {
        p(i, j) -= factor * p(k, j);
        b(i, j) -= factor * b(k, j);
      }
    }
  }
  return b;
}

}  // namespace

std::optional<GoldmanMaps> goldman_maps(const MatrixSet<Rational>& set,
                                        const Matrix<Rational>& control) {
  check_maps(set);
  const int n = set.size();
  if (control.rows() != n)
    throw InvalidField("matrices for " + std::to_string(n) + " control points were given " +
                       std::to_string(control.rows()));
  GoldmanMaps result;
  result.padded = with_column(control, std::vector<Rational>(static_cast<std::size_t>(n), 1));
  int rank = exact_rank(result.padded);
  if (rank < result.padded.cols()) return std::nullopt;
  for (int k = 0; k < n && rank < n; ++k) {
    std::vector<Rational> unit(static_cast<std::size_t>(n), Rational(0));
    unit[static_cast<std::size_t>(k)] = 1;
    Matrix<Rational> longer = with_column(result.padded, unit);
    if (exact_rank(longer) == rank) continue;
    result.padded = std::move(longer);
    ++result.padding;
    ++rank;
  }
  for (const Matrix<Rational>& a : set.maps)
    result.maps.push_back(solved(result.padded, a * result.padded));
  return result;
}

}  // namespace arete
