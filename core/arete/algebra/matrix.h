// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace arete {

/// A small dense matrix over any coefficient ring (exact rationals, integers, doubles), row major.
/// Only what exact algebra needs; large floating-point work belongs to Eigen.
template <class R>
class Matrix {
 public:
  Matrix() = default;
  /// rows x cols zeros.
  Matrix(int rows, int cols)
      : rows_(rows),
        cols_(cols),
        entries_(static_cast<std::size_t>(rows) * static_cast<std::size_t>(cols), R(0)) {}

  [[nodiscard]] static Matrix identity(int n) {
    Matrix result(n, n);
    for (int i = 0; i < n; ++i) result(i, i) = R(1);
    return result;
  }

  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] int cols() const { return cols_; }
  [[nodiscard]] R& operator()(int i, int j) { return entries_[index(i, j)]; }
  [[nodiscard]] const R& operator()(int i, int j) const { return entries_[index(i, j)]; }

  [[nodiscard]] friend bool operator==(const Matrix&, const Matrix&) = default;

  /// a.cols() == b.rows().
  [[nodiscard]] friend Matrix operator*(const Matrix& a, const Matrix& b) {
    Matrix product(a.rows_, b.cols_);
    for (int i = 0; i < a.rows_; ++i)
      for (int k = 0; k < a.cols_; ++k) {
        if (a(i, k) == R(0)) continue;
        for (int j = 0; j < b.cols_; ++j) product(i, j) = product(i, j) + a(i, k) * b(k, j);
      }
    return product;
  }

  [[nodiscard]] Matrix scaled(const R& factor) const {
    Matrix result = *this;
    for (R& entry : result.entries_) entry = entry * factor;
    return result;
  }

 private:
  [[nodiscard]] std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(cols_) +
           static_cast<std::size_t>(j);
  }

  int rows_ = 0;
  int cols_ = 0;
  std::vector<R> entries_;
};

}  // namespace arete
