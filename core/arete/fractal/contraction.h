// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>

#include "arete/fractal/matrix_set.h"

namespace arete {

/// Dobrushin's coefficient of ergodicity: half the largest distance (sum of absolute differences)
/// of two rows of a. If x is a row whose entries sum to 0 and rows of a sum to 1, then
/// |x a|_1 <= coefficient |x|_1; it is submultiplicative.
template <class R>
[[nodiscard]] R ergodicity_coefficient(const Matrix<R>& a) {
  R largest(0);
  for (int i = 0; i < a.rows(); ++i)
    for (int j = i + 1; j < a.rows(); ++j) {
      R distance(0);
      for (int k = 0; k < a.cols(); ++k)
        distance = distance + (a(i, k) < a(j, k) ? R(a(j, k) - a(i, k)) : R(a(i, k) - a(j, k)));
      largest = std::max(largest, R(distance / R(2)));
    }
  return largest;
}

/// How fast the arcs shrink: every product of `power` matrices has an ergodicity coefficient of at
/// most `coefficient` < 1, all shorter ones at most `shorter` (>= 1). So for any two starting
/// points with barycentric rows b, c,
///
///     |b A_w P - c A_w P| <= 1/2 |b - c|_1 shorter coefficient^floor(depth/power) diameter(P),
///
/// the deterministic algorithm converges to one attractor whatever it starts from, and this bounds
/// the Hausdorff distance between its pictures.
template <class R>
struct Contraction {
  int power = 1;
  R coefficient;
  R shorter;
};

/// The smallest power up to max_power that shows contraction; nothing if none does (which is no
/// proof of the contrary). Cost: arity^max_power matrix products.
/// \throws InvalidScheme see check_maps.
template <class R>
[[nodiscard]] std::optional<Contraction<R>> find_contraction(const MatrixSet<R>& set,
                                                             int max_power = 8) {
  check_maps(set);
  std::vector<Matrix<R>> products{Matrix<R>::identity(set.size())};
  R shorter(1);
  for (int power = 1; power <= max_power; ++power) {
    std::vector<Matrix<R>> longer;
    R largest(0);
    for (const Matrix<R>& product : products)
      for (const Matrix<R>& map : set.maps) {
        longer.push_back(map * product);
        largest = std::max(largest, ergodicity_coefficient(longer.back()));
      }
    if (largest < R(1)) return Contraction<R>{power, largest, shorter};
    shorter = std::max(shorter, largest);
    products = std::move(longer);
  }
  return std::nullopt;
}

}  // namespace arete
