// SPDX-License-Identifier: MIT
#include "arete/reverse/condition.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <utility>
#include <vector>

namespace arete {
namespace {

using Filter = std::vector<std::pair<Index, double>>;  // place, weight

constexpr int frequencies = 4096;

// sum_r |f_r(e^iw)|^2 over the phases of a filter, at every frequency.
std::vector<double> squared_norms(const Filter& filter, Index arity) {
  std::vector<double> norms;
  for (int k = 0; k < frequencies; ++k) {
    const double w = 2 * std::numbers::pi * k / frequencies;
    std::vector<std::complex<double>> phases(static_cast<std::size_t>(arity));
    for (const auto& [place, weight] : filter) {
      const Index q = floor_divide(place, arity);
      phases[static_cast<std::size_t>(place - arity * q)] +=
          weight * std::polar(1.0, w * static_cast<double>(q));
    }
    double sum = 0;
    for (const auto& phase : phases) sum += std::norm(phase);
    norms.push_back(sum);
  }
  return norms;
}

// The filter that gives a coarse sample in the middle of a long closed axis.
std::optional<Filter> local_weights(const Mask& mask) {
  const Index m = mask.arity();
  const Index coarse = 8 + 2 * static_cast<Index>(mask.coefficients().size());
  const ReverseLevel level(mask, m * coarse, Boundary::periodic);
  const auto reverse = local_reverse<double>(mask, level, Boundary::periodic);
  if (!reverse) return std::nullopt;
  Filter filter;
  for (const auto& [col, weight] : reverse->analysis.row(coarse / 2))
    filter.emplace_back(col, weight);
  return filter;
}

}  // namespace

std::optional<ReverseCondition> reverse_condition(const Mask& mask, ReverseMode mode) {
  Filter symbol;
  for (int k = mask.first(); k <= mask.last(); ++k) symbol.emplace_back(k, to_double(mask[k]));
  const std::vector<double> norms = squared_norms(symbol, mask.arity());
  const double largest = *std::max_element(norms.begin(), norms.end());
  const double least = *std::min_element(norms.begin(), norms.end());
  if (mode == ReverseMode::least_squares) {
    if (!(least > 1e-20 * largest)) return std::nullopt;
    double mean = 0;
    for (const double norm : norms) mean += 1 / norm / frequencies;
    return ReverseCondition{std::sqrt(mean), std::sqrt(largest / least)};
  }
  const auto filter = local_weights(mask);
  if (!filter) return std::nullopt;
  double gain = 0;
  for (const auto& [place, weight] : *filter) gain += weight * weight;
  const std::vector<double> filter_norms = squared_norms(*filter, mask.arity());
  return ReverseCondition{
      std::sqrt(gain),
      std::sqrt(largest * *std::max_element(filter_norms.begin(), filter_norms.end()))};
}

}  // namespace arete
