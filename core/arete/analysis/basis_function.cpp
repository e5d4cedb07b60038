// SPDX-License-Identifier: MIT
#include "arete/analysis/basis_function.h"

#include <cmath>
#include <stdexcept>

namespace arete {

BasisSamples basis_function(const Mask& mask, int order, int least) {
  if (order < 0) throw std::invalid_argument("the order of a derivative must not be negative");
  const int m = mask.arity();
  LaurentPolynomial<Rational> derived = mask.symbol();
  std::vector<double> values = {1};
  for (int k = 0; k < order; ++k) {
    auto quotient = derived.divided_by_smoothing_factor(m);
    if (!quotient)
      throw std::invalid_argument("a derivative of order " + std::to_string(order) + " needs " +
                                  std::to_string(order) + " sum rules");
    derived = quotient->scaled(Rational(m));
    values.push_back(0);
    for (std::size_t i = values.size(); i-- > 1;) values[i] -= values[i - 1];
  }
  std::vector<double> taps;
  for (const Rational& c : derived.coefficients()) taps.push_back(to_double(c));

  // Sample i of level L is near the limit at (i + tau/(m - 1))/m^L, tau that of the derived scheme.
  const double tau = to_double(derived.derivative().sum()) / m;
  double lowest = 0;
  double dilation = 1;
  do {
    std::vector<double> next((values.size() - 1) * static_cast<std::size_t>(m) + taps.size(), 0.0);
    for (std::size_t i = 0; i < values.size(); ++i)
      for (std::size_t k = 0; k < taps.size(); ++k)
        next[i * static_cast<std::size_t>(m) + k] += values[i] * taps[k];
    values = std::move(next);
    lowest = m * lowest + derived.lowest();
    dilation *= m;
  } while (values.size() < static_cast<std::size_t>(least));
  values.insert(values.begin(), 0.0);
  values.push_back(0.0);
  return {(lowest - 1 + tau / (m - 1)) / dilation, 1 / dilation, std::move(values)};
}

}  // namespace arete
