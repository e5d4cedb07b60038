// SPDX-License-Identifier: MIT
#pragma once

#include "arete/fractal/matrix_set.h"

namespace arete {

/// What the matrices do to differences: with (Delta p)_i = p_{i+1} - p_i,
///
///     Delta A = D Delta,   D of size n - 1.
///
/// The curve is continuous iff the joint spectral radius of all D is below 1, and its Hoelder
/// exponent in the m-adic parameter is -log_m of it. Rows of A must sum to 1 (else there is no D).
template <class R>
[[nodiscard]] MatrixSet<R> difference_matrices(const MatrixSet<R>& set) {
  check_maps(set);
  MatrixSet<R> differences;
  const int n = set.size() - 1;
  for (const Matrix<R>& a : set.maps) {
    Matrix<R> d(n, n);
    for (int i = 0; i < n; ++i) {
      // Row i of Delta A is sum_j D_ij (e_{j+1} - e_j), so D_ij = -(its first j + 1 entries' sum).
      R sum(0);
      for (int j = 0; j < n; ++j) {
        sum = sum + (a(i, j) - a(i + 1, j));
        d(i, j) = sum;
      }
    }
    differences.maps.push_back(std::move(d));
  }
  return differences;
}

}  // namespace arete
