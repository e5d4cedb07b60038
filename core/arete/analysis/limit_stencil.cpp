// SPDX-License-Identifier: MIT
#include "arete/analysis/limit_stencil.h"

#include <cmath>
#include <stdexcept>

#include "arete/algebra/linear_solve.h"
#include "arete/analysis/certificate.h"

namespace arete {
namespace {

// Smallest integer > p/q and largest integer < p/q, q > 0.
int above(int p, int q) { return static_cast<int>(std::floor(static_cast<double>(p) / q)) + 1; }
int below(int p, int q) { return static_cast<int>(std::ceil(static_cast<double>(p) / q)) - 1; }

// Bareiss on n unknowns whose entries have `bits` bits works on numbers of up to n * bits bits.
bool affordable(const Mask& mask, int unknowns) {
  Integer denominator = 1;
  Integer largest = 1;
  for (const Rational& c : mask.coefficients()) {
    denominator = lcm(denominator, boost::multiprecision::denominator(c));
    largest = std::max(largest, Integer(abs(boost::multiprecision::numerator(c))));
  }
  const double bits = static_cast<double>(msb(denominator)) + static_cast<double>(msb(largest)) + 1;
  const double n = unknowns;
  const double words = 1 + n * bits / 64;
  return n * n * n * (20 + words * words) < 2e10;
}

Stencil trimmed(int first, std::vector<Rational> weights) {
  while (!weights.empty() && weights.back() == 0) weights.pop_back();
  while (!weights.empty() && weights.front() == 0) {
    weights.erase(weights.begin());
    ++first;
  }
  return {first, std::move(weights)};
}

}  // namespace

std::optional<Stencil> limit_stencil(const Mask& mask) { return derivative_stencil(mask, 0); }

std::optional<Stencil> derivative_stencil(const Mask& mask, int order) {
  if (order < 0) throw std::invalid_argument("the order of a derivative must not be negative");
  const int m = mask.arity();
  // phi and its continuous derivatives vanish at the ends of the support.
  const int lowest = above(mask.first(), m - 1);
  const int highest = below(mask.last(), m - 1);
  const int n = highest - lowest + 1;
  if (n < 1 || n > largest_stencil_support || !affordable(mask, n)) return std::nullopt;
  if (certify(mask, 8).order < order) return std::nullopt;

  Matrix<Rational> equations(n + order + 1, n);
  std::vector<Rational> right(static_cast<std::size_t>(n + order + 1), Rational(0));
  const Rational eigenvalue = Rational(1) / power(Rational(m), static_cast<unsigned>(order));
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      equations(i, j) = mask[m * (lowest + i) - (lowest + j)] - (i == j ? eigenvalue : Rational(0));
  // The weight of p_j is the unknown at -j: sum_i (-i)^l phi_i = order! for l = order, else 0.
  for (int l = 0; l <= order; ++l)
    for (int j = 0; j < n; ++j)
      equations(n + l, j) = power(Rational(-(lowest + j)), static_cast<unsigned>(l));
  Rational factorial = 1;
  for (int l = 2; l <= order; ++l) factorial *= l;
  right.back() = factorial;

  auto values = solve_unique(equations, right);
  if (!values) return std::nullopt;
  return trimmed(-highest, std::vector<Rational>(values->rbegin(), values->rend()));
}

}  // namespace arete
