// SPDX-License-Identifier: GPL-3.0-or-later
#include "arete/meshlab/smoothness_report.h"

#include <cstdio>
#include <optional>

#include "arete/analysis/limit_stencil.h"
#include "arete/analysis/polynomial.h"
#include "arete/analysis/theorem.h"

namespace arete::meshlab {
namespace {

std::string decimal(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

// i, (i - 1/2) or (i + 1/2).
std::string place_text(const Mask& mask) {
  const Rational tau = mask.tau();
  if (tau == 0) return "i";
  return tau > 0 ? "(i - " + to_string(tau) + ")" : "(i + " + to_string(Rational(-tau)) + ")";
}

std::string stencil_text(const std::optional<Stencil>& stencil) {
  if (!stencil) return "none that is certain";
  std::string text;
  for (std::size_t i = 0; i < stencil->weights.size(); ++i) {
    if (stencil->weights[i] == 0) continue;
    if (!text.empty()) text += ", ";
    text += to_string(stencil->weights[i]) + " at " +
            std::to_string(stencil->first + static_cast<int>(i));
  }
  return text;
}

std::string verdict_text(const OrderVerdict& verdict) {
  const std::string order = "C^" + std::to_string(verdict.order) + ": ";
  switch (verdict.verdict) {
    case Verdict::certified:
      return order + "certified, " + explanation(verdict);
    case Verdict::refuted:
      return order + "refuted, " + explanation(verdict);
    case Verdict::undecided:
      break;
  }
  return order + "undecided, " + explanation(verdict);
}

std::string hoelder_text(const HoelderBounds& hoelder) {
  std::string text = "Hoelder exponent: ";
  if (hoelder.stability != Stability::stable)
    text += "at least " + decimal(hoelder.lower) + " (the shifts are not known to be stable)";
  else if (hoelder.lower == hoelder.upper)
    text += decimal(hoelder.lower) + ", exactly";
  else if (decimal(hoelder.lower) == decimal(hoelder.upper))
    text += decimal(hoelder.lower) + " to all digits shown";
  else
    text += "between " + decimal(hoelder.lower) + " and " + decimal(hoelder.upper);
  if (hoelder.attained == Attained::no) text += ", not attained: only every smaller one holds";
  if (hoelder.attained == Attained::yes) text += ", attained";
  return text;
}

std::string theorem_text(const TheoremResult& theorem, const Smoothness& truth) {
  std::string text = theorem.name + " (" + theorem.statement + ") " +
                     (theorem.holds ? "holds" : "does not hold") + "; it promises C^" +
                     std::to_string(theorem.claims);
  switch (compare(theorem, truth)) {
    case Comparison::confirmed:
      return text + ", which is confirmed";
    case Comparison::contradicted:
      return text + ", which is REFUTED: " + theorem.remark;
    case Comparison::too_weak:
      return text + ", which is true all the same";
    case Comparison::silent:
      return text + ", which is not certified either";
    case Comparison::open:
      break;
  }
  return text + ", which nothing else decides";
}

}  // namespace

void report_smoothness(const Scheme& scheme, int max_power, Report& report) {
  const Mask& mask = scheme.mask();
  const std::string arity = std::to_string(mask.arity());
  report.progress(0, "Describing the scheme");
  report.log("Scheme " + scheme.text());
  report.log("Mask " + coefficients_text(mask) + " on the indices " + std::to_string(mask.first()) +
             " to " + std::to_string(mask.last()) + ", arity " + arity);
  report.log("New sample i lies at " + place_text(mask) + "/" + arity + "; the scheme " +
             (is_interpolatory(mask) ? "interpolates" : "approximates"));
  report.log(std::to_string(sum_rules(mask)) + " sum rules; polynomials of degree " +
             std::to_string(reproduction_degree(mask)) + " are reproduced");
  report.log("One level leaves the range of the heights by at most " + to_string(overshoot(mask)) +
             " of that range along each axis");
  report.progress(10, "Proving smoothness");
  SmoothnessOptions options;
  options.max_power = max_power;
  const Smoothness smoothness = analyze_smoothness(mask, options);
  for (const OrderVerdict& verdict : smoothness.orders) report.log(verdict_text(verdict));
  report.log(hoelder_text(smoothness.hoelder));
  for (const TheoremResult& theorem : theorems_for(scheme))
    report.log(theorem_text(theorem, smoothness));
  report.progress(80, "Computing limit stencils");
  report.log("Limit at an old sample: " + stencil_text(limit_stencil(mask)));
  report.log("Derivative there: " + stencil_text(derivative_stencil(mask)));
  report.log("The mesh is as it was");
}

}  // namespace arete::meshlab
