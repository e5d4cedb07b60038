// SPDX-License-Identifier: MIT
#include "arete/analysis/parameter_interval.h"

#include <utility>

namespace arete {
namespace {

// The last value where it holds and the first where it fails, on the side of the sign.
std::pair<Rational, Rational> edge(const std::function<bool(const Rational&)>& holds,
                                   const IntervalSearch& search, int sign) {
  Rational good = search.start;
  Rational bad = good;
  while (true) {
    bad = good + sign * search.step;
    if (abs(bad - search.start) > search.reach) return {good, good};
    if (!holds(bad)) break;
    good = bad;
  }
  while (abs(bad - good) > search.tolerance) {
    const Rational middle = (good + bad) / 2;
    (holds(middle) ? good : bad) = middle;
  }
  return {good, bad};
}

}  // namespace

std::optional<ParameterInterval> interval_where(const std::function<bool(const Rational&)>& holds,
                                                const IntervalSearch& search) {
  if (!holds(search.start)) return std::nullopt;
  const auto [lower, below] = edge(holds, search, -1);
  const auto [upper, above] = edge(holds, search, 1);
  return ParameterInterval{lower, upper, below, above};
}

}  // namespace arete
