// SPDX-License-Identifier: MIT
#include "arete/analysis/smoothness.h"

#include <cmath>
#include <cstdio>

namespace arete {
namespace {

constexpr int largest_tested = 40;  // dimension of matrices whose words are tested exactly

// m^order rho(word)^{1/length} for people, in floating point.
double word_value(const HoelderBounds& hoelder, int arity, int order) {
  return to_double(hoelder.jsr.lower) * std::pow(arity, order);
}

}  // namespace

Smoothness analyze_smoothness(const Mask& mask, const SmoothnessOptions& options) {
  Smoothness result;
  const int m = mask.arity();
  const FactoredMask parts = factored(mask);
  result.hoelder = hoelder_bounds(mask, options.jsr);
  const JsrBounds& jsr = result.hoelder.jsr;
  const bool stable = result.hoelder.stability == Stability::stable;
  result.certificate = certify(mask, options.max_power, options.work_budget, options.jsr.stop);
  result.complete = !must_stop(options.jsr.stop);
  const LocalMatrices local = local_matrices(m, parts.rest);

  for (int order = 0; order <= parts.rules; ++order) {
    OrderVerdict verdict;
    verdict.order = order;
    const Rational scale = power(Rational(m), static_cast<unsigned>(order));
    const OrderProof* proof = nullptr;
    for (const OrderProof& candidate : result.certificate.proofs)
      if (candidate.order == order) proof = &candidate;
    if (proof != nullptr) {
      verdict.verdict = Verdict::certified;
      verdict.reason = Reason::norm;
      verdict.power = proof->power;
      verdict.norm = proof->norm;
    } else if (order < parts.rules && jsr.upper * scale < 1) {
      verdict.verdict = Verdict::certified;
      verdict.reason = Reason::spectral_bound;
      verdict.norm = jsr.upper * scale;
    } else if (result.refuted_at) {
      verdict.verdict = Verdict::refuted;
      verdict.reason = Reason::divergence;
    } else if (order < parts.rules && (order == 0 || stable) && !jsr.word.empty() &&
               local.size <= largest_tested && !must_stop(options.jsr.stop) &&
               word_reaches(local, jsr.word, 1 / scale)) {
      verdict.verdict = Verdict::refuted;
      verdict.reason = Reason::word;
      verdict.word = jsr.word;
      verdict.value = std::max(1.0, word_value(result.hoelder, m, order));
    } else if (order == parts.rules && stable) {
      verdict.verdict = Verdict::refuted;
      verdict.reason = Reason::sum_rules;
    }
    if (verdict.verdict == Verdict::certified) result.certified = order;
    if (verdict.verdict == Verdict::refuted && !result.refuted_at) result.refuted_at = order;
    result.orders.push_back(std::move(verdict));
  }
  return result;
}

std::string explanation(const OrderVerdict& verdict) {
  char number[64];
  switch (verdict.reason) {
    case Reason::norm:
      return "the norm of power " + std::to_string(verdict.power) + " is " +
             to_string(verdict.norm) + " < 1";
    case Reason::spectral_bound:
      std::snprintf(number, sizeof number, "%.9g", to_double(verdict.norm));
      return std::string("the joint spectral radius is at most ") + number + " < 1 (scaled)";
    case Reason::word:
      std::snprintf(number, sizeof number, "%.9g", verdict.value);
      return "word " + to_text(verdict.word) + " has value " + number + " >= 1";
    case Reason::sum_rules:
      return "only " + std::to_string(verdict.order) +
             (verdict.order == 1 ? " sum rule" : " sum rules") + " and stable shifts";
    case Reason::divergence:
      return "a lower order is refuted";
    case Reason::none:
      break;
  }
  return "neither proved nor refuted";
}

}  // namespace arete
