// SPDX-License-Identifier: MIT
#include "arete/analysis/polynomial.h"

#include <algorithm>

namespace arete {
namespace {

std::size_t phase_of(int index, int arity) {
  return static_cast<std::size_t>(((index % arity) + arity) % arity);
}

}  // namespace

int sum_rules(const Mask& mask) {
  int rules = 0;
  auto quotient = mask.symbol().divided_by_smoothing_factor(mask.arity());
  while (quotient) {
    ++rules;
    quotient = quotient->divided_by_smoothing_factor(mask.arity());
  }
  return rules;
}

int reproduction_degree(const Mask& mask) {
  const Rational tau = mask.tau();
  const int most = sum_rules(mask) - 1;
  LaurentPolynomial<Rational> derivative = mask.symbol();
  Rational wanted = mask.arity();
  for (int degree = 0; degree <= most; ++degree) {
    if (derivative.sum() != wanted) return degree - 1;
    derivative = derivative.derivative();
    wanted *= tau - degree;
  }
  return most;
}

bool is_interpolatory(const Mask& mask) {
  const int m = mask.arity();
  std::vector<int> taps(static_cast<std::size_t>(m), 0);
  for (int k = mask.first(); k <= mask.last(); ++k)
    if (mask[k] != 0) ++taps[phase_of(k, m)];
  // A phase with a single tap has the weight 1, because it sums to 1.
  return std::find(taps.begin(), taps.end(), 1) != taps.end();
}

Rational step_norm(const Mask& mask) {
  std::vector<Rational> sums(static_cast<std::size_t>(mask.arity()), Rational(0));
  for (int k = mask.first(); k <= mask.last(); ++k) sums[phase_of(k, mask.arity())] += abs(mask[k]);
  return *std::max_element(sums.begin(), sums.end());
}

Rational overshoot(const Mask& mask) { return (step_norm(mask) - 1) / 2; }

}  // namespace arete
