// SPDX-License-Identifier: MIT
#include "arete/analysis/ternary_theorem.h"

#include "arete/analysis/certificate.h"
#include "arete/scheme/family/ternary.h"

namespace arete {

const std::array<TernaryInterval, 3>& ternary_intervals() {
  static const std::array<TernaryInterval, 3> intervals = {{
      {0, parse_rational("-10.2816"), parse_rational("10.372"), {-3357, -162, 16}, {-4293, 82, 32}},
      {1, parse_rational("-2.34233"), parse_rational("2.7915"), {-18, -3, 2}, {-87, 20, 4}},
      {2,
       parse_rational("-0.469119"),
       parse_rational("0.483101"),
       {-1233, -2208, 896},
       {-333, 612, 160}},
  }};
  return intervals;
}

std::vector<TheoremResult> ternary_results(const Rational& b) {
  const Mask mask(3, family::ternary_two_step<Rational>(b));
  std::vector<TheoremResult> results;
  for (const TernaryInterval& interval : ternary_intervals()) {
    TheoremResult result;
    result.name = "theorem 3.1, C^" + std::to_string(interval.order) + " (Zhong, Qi)";
    result.statement = "|| ((1/3) S_" + std::to_string(interval.order + 1) + ")^2 || < 1";
    result.claims = interval.order;
    result.values = {*contractivity_norm(mask, interval.order, 2)};
    result.holds = result.values.front() < 1;
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace arete
