// SPDX-License-Identifier: MIT
#pragma once

#include "arete/fractal/matrix_set.h"

namespace arete {

/// The Kronecker product: (a x b)_{(i,k),(j,l)} = a_ij b_kl, pairs numbered i * b.rows() + k.
template <class R>
[[nodiscard]] Matrix<R> kronecker(const Matrix<R>& a, const Matrix<R>& b) {
  Matrix<R> product(a.rows() * b.rows(), a.cols() * b.cols());
  for (int i = 0; i < a.rows(); ++i)
    for (int j = 0; j < a.cols(); ++j)
      for (int k = 0; k < b.rows(); ++k)
        for (int l = 0; l < b.cols(); ++l)
          product(i * b.rows() + k, j * b.cols() + l) = a(i, j) * b(k, l);
  return product;
}

/// The maps of a tensor-product patch: its control net has rows (the first index, ruled by `rows`)
/// and columns (the second, ruled by `cols`), point (i, j) being number i * cols.size() + j. For
/// two pairs these are B1..B4 = L x L, L x R, R x L, R x R in this order. The eigenvalues are the
/// products of those of the factors.
template <class R>
[[nodiscard]] MatrixSet<R> tensor_product(const MatrixSet<R>& rows, const MatrixSet<R>& cols) {
  MatrixSet<R> product;
  for (const Matrix<R>& a : rows.maps)
    for (const Matrix<R>& b : cols.maps) product.maps.push_back(kronecker(a, b));
  return product;
}

}  // namespace arete
