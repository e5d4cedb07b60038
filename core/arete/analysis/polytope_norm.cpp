// SPDX-License-Identifier: MIT
#include "arete/analysis/polytope_norm.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace arete {
namespace {

constexpr double optimality = 1e-11;
constexpr double pivot_size = 1e-8;
constexpr double perturbation = 1e-12;

}  // namespace

void PolytopeNorm::add(std::vector<double> point) { points_.push_back(std::move(point)); }

// Gauss-Jordan with row pivoting; false if the basis is numerically dependent.
bool PolytopeNorm::invert_basis() {
  const auto n = static_cast<std::size_t>(dimension_);
  std::vector<double> a(n * n);
  inverse_.assign(n * n, 0.0);
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i < n; ++i) a[i * n + j] = point(basis_[j])[i];
    inverse_[j * n + j] = 1;
  }
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i)
      if (std::abs(a[i * n + k]) > std::abs(a[pivot * n + k])) pivot = i;
    if (std::abs(a[pivot * n + k]) < 1e-14) return false;
    for (std::size_t j = 0; j < n && pivot != k; ++j) {
      std::swap(a[pivot * n + j], a[k * n + j]);
      std::swap(inverse_[pivot * n + j], inverse_[k * n + j]);
    }
    const double scale = 1 / a[k * n + k];
    for (std::size_t j = 0; j < n; ++j) {
      a[k * n + j] *= scale;
      inverse_[k * n + j] *= scale;
    }
    for (std::size_t i = 0; i < n; ++i) {
      const double factor = a[i * n + k];
      if (i == k || factor == 0) continue;
      for (std::size_t j = 0; j < n; ++j) {
        a[i * n + j] -= factor * a[k * n + j];
        inverse_[i * n + j] -= factor * inverse_[k * n + j];
      }
    }
  }
  return true;
}

PolytopeNorm::Combination PolytopeNorm::combine(const std::vector<double>& x, double good_enough) {
  const auto n = static_cast<std::size_t>(dimension_);
  if (basis_.empty()) {
    basis_.resize(n);
    std::iota(basis_.begin(), basis_.end(), 0);
    invert_basis();
  }
  const auto apply_inverse = [this, n](const std::vector<double>& b, std::vector<double>& result) {
    for (std::size_t i = 0; i < n; ++i) {
      result[i] = 0;
      for (std::size_t j = 0; j < n; ++j) result[i] += inverse_[i * n + j] * b[j];
    }
  };
  std::vector<double> weights(n);
  std::vector<double> dual(n);
  std::vector<double> direction(n);
  std::vector<double> signs(n);
  apply_inverse(x, weights);
  double norm = 0;
  for (const double weight : weights) norm += std::abs(weight);

  // Degenerate vertices are the rule here, so x is moved a little to where no weight is zero.
  std::vector<double> moved = x;
  for (std::size_t i = 0; i < n; ++i) {
    signs[i] = std::copysign(1.0, weights[i]);
    const double shift =
        signs[i] * perturbation * (1 + norm) * (1 + 0.618 * static_cast<double>(i));
    for (std::size_t j = 0; j < n; ++j) moved[j] += shift * point(basis_[i])[j];
  }
  const int most_pivots = 60 * dimension_ + 200;
  for (int pivots = 0; pivots < most_pivots && norm > good_enough; ++pivots) {
    // Dual: y with y . v = sign on the basis; a point with |y . v| > 1 shortens the sum.
    std::fill(dual.begin(), dual.end(), 0.0);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) dual[j] += signs[i] * inverse_[i * n + j];
    int entering = -1;
    double slope = 1 + optimality;
    double sign = 1;
    for (int k = 0; k < count(); ++k) {
      const double* v = points_[static_cast<std::size_t>(k)].data();
      double product = 0;
      for (std::size_t j = 0; j < n; ++j) product += dual[j] * v[j];
      if (std::abs(product) > slope) {
        entering = k;
        slope = std::abs(product);
        sign = std::copysign(1.0, product);
      }
    }
    if (entering < 0) break;                                   // optimal
    if (good_enough > 0 && norm / slope > good_enough) break;  // dual bound

    apply_inverse(point(entering), direction);
    apply_inverse(moved, weights);
    std::size_t leaving = n;
    double step = 0;
    double leaving_rate = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double rate = signs[i] * sign * direction[i];
      if (rate <= pivot_size) continue;
      // Of nearly equal ratios the largest rate: it keeps the basis well conditioned.
      const double ratio = std::max(0.0, signs[i] * weights[i]) / rate;
      if (leaving == n || ratio < step * (1 - 1e-9) ||
          (ratio <= step * (1 + 1e-9) && rate > leaving_rate)) {
        leaving = i;
        leaving_rate = rate;
        step = ratio;
      }
    }
    if (leaving == n) break;
    const int left = std::exchange(basis_[leaving], entering);
    if (!invert_basis()) {
      basis_[leaving] = left;
      invert_basis();
      break;
    }
    signs[leaving] = sign;
    apply_inverse(x, weights);
    norm = 0;
    for (const double weight : weights) norm += std::abs(weight);
  }
  apply_inverse(x, weights);
  return {norm, basis_, weights};
}

}  // namespace arete
