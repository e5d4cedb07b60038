// SPDX-License-Identifier: MIT
#include "arete/analysis/theorem.h"

#include "arete/analysis/corner_cutting_facts.h"
#include "arete/analysis/difference_theorems.h"
#include "arete/analysis/four_parameter_theorems.h"
#include "arete/analysis/ternary_theorem.h"

namespace arete {
namespace {

// (1+z)/2 raises the smoothness by one each time; convergent differences give C^0 unraised.
std::vector<TheoremResult> difference_results(const std::vector<Rational>& coefficients,
                                              int raise) {
  if (coefficients.size() != 2 && coefficients.size() != 3) return {};
  TheoremResult result = difference_theorem(coefficients);
  result.claims = raise;
  return {result};
}

Rational two_to_minus(int m) { return Rational(1) / power(Rational(2), static_cast<unsigned>(m)); }

}  // namespace

Comparison compare(const TheoremResult& theorem, const Smoothness& truth) {
  const bool certified = truth.certified >= theorem.claims;
  const bool refuted = truth.refuted_at && *truth.refuted_at <= theorem.claims;
  if (!theorem.holds) return certified ? Comparison::too_weak : Comparison::silent;
  if (certified) return Comparison::confirmed;
  return refuted ? Comparison::contradicted : Comparison::open;
}

std::vector<TheoremResult> theorems_for(const Scheme& scheme) {
  const std::string& name = scheme.name();
  const ParameterValues& p = scheme.parameters();
  const Rational half = Rational(1) / 2;
  if (name == "four-parameter")
    return four_parameter_results(number(p, "lambda"), number(p, "mu"), number(p, "nu"),
                                  number(p, "omega"));
  if (name == "four-point" || name == "gentle" || name == "craggy") {
    // Members with nu = 1/2: read lambda, mu and omega off the mask.
    const Mask& mask = scheme.mask();
    return four_parameter_results(mask[2], mask[-2], half, -mask[3]);
  }
  if (name == "four-parameter-c2") {
    const Rational nu = number(p, "nu");
    const Rational omega = number(p, "omega");
    const Mask& mask = scheme.mask();
    return four_parameter_results(mask[2], mask[-2], nu, omega);
  }
  if (name == "two-parameter") {
    const Rational a = number(p, "a");
    return difference_results({two_to_minus(integer(p, "m")) - a, a}, integer(p, "raise"));
  }
  if (name == "three-parameter") {
    const Rational a = number(p, "a");
    const Rational c = number(p, "c");
    return difference_results({c, two_to_minus(integer(p, "m")) - a - c, a}, integer(p, "raise"));
  }
  if (name == "three-point") {
    const Rational a = -half / 2;
    return difference_results({half - a, a}, 1);
  }
  if (name == "difference") {
    std::vector<Rational> coefficients;
    for (const ParameterValue& value : p)
      if (value.name.front() == 'a') coefficients.push_back(value.numbers.front());
    return difference_results(coefficients, integer(p, "raise"));
  }
  if (name == "ternary-two-step" || name == "ternary-two-step-9")
    return ternary_results(number(p, "b"));
  if (name == "corner-cutting") return corner_cutting_results(number(p, "u"), number(p, "v"));
  if (name == "chaikin" || name == "de-rham")
    return corner_cutting_results(scheme.mask()[-2], scheme.mask()[1]);
  return {};
}

}  // namespace arete
