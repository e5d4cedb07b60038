// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "arete/analysis/certificate.h"
#include "arete/analysis/hoelder.h"

namespace arete {

enum class Verdict { certified, refuted, undecided };

/// What decided an order.
enum class Reason {
  none,            ///< undecided
  norm,            ///< certified: an exact norm of a power is below 1
  spectral_bound,  ///< certified: the proved upper bound of the JSR is small enough
  word,            ///< refuted: a word of local matrices, by an exact Schur-Cohn test
  sum_rules,       ///< refuted: stable shifts and too few sum rules
  divergence       ///< refuted: the scheme does not even converge, or a lower order is refuted
};

/// "Are all limit functions C^order?" (order 0: does the scheme converge uniformly?)
struct OrderVerdict {
  int order = 0;
  Verdict verdict = Verdict::undecided;
  Reason reason = Reason::none;
  int power = 0;     ///< of the norm
  Rational norm;     ///< for Reason::norm: the norm; for spectral_bound: m^order times the bound
  Word word;         ///< for Reason::word
  double value = 0;  ///< for Reason::word: m^order times the averaged spectral radius, >= 1
};

struct SmoothnessOptions {
  int max_power = 8;  ///< of the norms
  std::int64_t work_budget = default_work_budget;
  JsrOptions jsr;  ///< its `stop` stops everything
};

/// Everything that is proved about the smoothness of a scheme. Orders 0..sum_rules are decided one
/// by one; "undecided" is said where neither side is proved. The limits
/// - are C^order if (1 + ... + z^{m-1})^{order+1} | a and m^order JSR(q_{order+1}) < 1;
/// - are not, for stable shifts (order 0: always), if m^order JSR(q_{order+1}) >= 1 or if there are
///   fewer than order + 1 sum rules.
/// Because JSR(q) = max(|q(1)|/m, JSR(q/(1 + ... + z^{m-1}))) all of them are read off q_N.
struct Smoothness {
  int certified = -1;             ///< the largest certified order, by whatever proof
  std::optional<int> refuted_at;  ///< the smallest refuted order
  std::vector<OrderVerdict> orders;
  Certificate certificate;  ///< what the norms alone prove
  HoelderBounds hoelder;    ///< carries the stability, too
  bool complete = true;     ///< false: stopped; more time might decide more
};

[[nodiscard]] Smoothness analyze_smoothness(const Mask& mask,
                                            const SmoothnessOptions& options = {});

/// `word 01 has value 1.047739 >= 1`: one line for people.
[[nodiscard]] std::string explanation(const OrderVerdict& verdict);

}  // namespace arete
