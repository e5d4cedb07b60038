// SPDX-License-Identifier: MIT
#include "arete/analysis/theorem.h"

#include <algorithm>
#include <limits>

#include "arete/analysis/corner_cutting_facts.h"
#include "arete/analysis/difference_theorems.h"
#include "arete/analysis/four_parameter_theorems.h"
#include "arete/analysis/ternary_theorem.h"

namespace arete {
namespace {

// The difference symbol (a0 + a1 z + ...)(1+z)^m of a family that is made from one.
struct DifferenceSymbol {
  std::vector<Rational> coefficients;
  int m = 1;
  int raise = 1;
};

std::optional<DifferenceSymbol> difference_symbol(const Scheme& scheme) {
  const std::string& name = scheme.name();
  const ParameterValues& p = scheme.parameters();
  if (name == "three-point") return DifferenceSymbol{{Rational(3) / 4, Rational(-1) / 4}, 1, 1};
  if (name != "two-parameter" && name != "three-parameter" && name != "difference")
    return std::nullopt;
  DifferenceSymbol symbol{{}, integer(p, "m"), integer(p, "raise")};
  if (name == "difference") {
    for (const ParameterValue& value : p)
      if (value.name.front() == 'a') symbol.coefficients.push_back(value.numbers.front());
    return symbol;
  }
  const Rational sum = Rational(1) / power(Rational(2), static_cast<unsigned>(symbol.m));
  const Rational& a = number(p, "a");
  const Rational c = name == "three-parameter" ? number(p, "c") : Rational(0);
  symbol.coefficients = {sum - a - c, a};
  if (name == "three-parameter") symbol.coefficients.insert(symbol.coefficients.begin(), c);
  return symbol;
}

// (1+z)/2 raises the smoothness by one each time; convergent differences give C^0 unraised.
std::vector<TheoremResult> difference_results(const DifferenceSymbol& symbol) {
  const auto degree = symbol.coefficients.size() - 1;
  std::vector<TheoremResult> results;
  if (degree == 1 || degree == 2) results.push_back(difference_theorem(symbol.coefficients));
  results.push_back(nonnegative_coefficients(symbol.coefficients));
  for (TheoremResult& result : results) result.claims = symbol.raise;
  if (degree == 1 || degree == 2) results.push_back(lemma_result(symbol.coefficients, symbol.m));
  return results;
}

std::string triple(const std::vector<Rational>& ascending) {
  return "(" + to_string(ascending[2]) + ", " + to_string(ascending[1]) + ", " +
         to_string(ascending[0]) + ")";
}

}  // namespace

std::optional<double> region_margin(const TheoremResult& theorem) {
  if (theorem.claims < 0 || (theorem.values.empty() && theorem.nonnegative.empty()))
    return std::nullopt;
  double margin = -std::numeric_limits<double>::infinity();
  for (const Rational& value : theorem.values)
    margin = std::max(margin, to_double(Rational(value - 1)));
  for (const Rational& value : theorem.nonnegative) margin = std::max(margin, -to_double(value));
  return margin;
}

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
  if (const auto symbol = difference_symbol(scheme)) return difference_results(*symbol);
  if (name == "ternary-two-step" || name == "ternary-two-step-9")
    return ternary_results(number(p, "b"));
  if (name == "corner-cutting") return corner_cutting_results(number(p, "u"), number(p, "v"));
  if (name == "chaikin" || name == "de-rham")
    return corner_cutting_results(scheme.mask()[-2], scheme.mask()[1]);
  return {};
}

std::optional<TheoremResult> property_1_refuted_by(const Scheme& scheme) {
  const auto symbol = difference_symbol(scheme);
  if (!symbol || symbol->coefficients.size() != 3) return std::nullopt;
  const auto pair = refuting_mixture(symbol->coefficients);
  if (!pair) return std::nullopt;
  TheoremResult result = mixture_property(pair->first, pair->second);
  result.claims = symbol->raise;
  result.remark += "; this scheme is the mean of (a, b, c) = " + triple(pair->first) + " and " +
                   triple(pair->second) + ", both proved convergent";
  return result;
}

}  // namespace arete
