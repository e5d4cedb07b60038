// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "arete/analysis/smoothness.h"
#include "arete/scheme/scheme.h"

namespace arete {

/// A published statement in its own form, evaluated for given parameters. A smoothness statement
/// "holds" if its printed hypothesis is met: every value < 1, every residual = 0, no negative
/// number among `nonnegative`.
struct TheoremResult {
  std::string name;       ///< `theorem 2 (Zhao, Peng, Ye)`
  std::string statement;  ///< the printed condition, one line
  int claims = 0;         ///< the order of smoothness promised where it holds; -1: none is
  bool holds = false;
  std::vector<Rational> values;     ///< what must be below 1
  std::vector<Rational> residuals;  ///< what must vanish
  bool sound = true;   ///< whether the statement itself is true (some of the published are not)
  std::string remark;  ///< what is true instead, where it is not sound; otherwise may be empty
  std::vector<Rational> nonnegative{};  ///< what must not be negative
};

/// How far the parameters are inside (negative) or outside (positive or zero) the printed
/// inequalities: the largest of value - 1 and of the negatives of `nonnegative`. Continuous in the
/// parameters, so that its zero line outlines their region; residuals are not looked at. Nothing
/// for statements that are not about a region (no inequality, or claims < 0).
[[nodiscard]] std::optional<double> region_margin(const TheoremResult& theorem);

/// How a statement compares with what is proved about the scheme.
enum class Comparison {
  confirmed,     ///< it holds, and the order it claims is certified independently
  contradicted,  ///< it holds, and the order it claims is refuted: a counterexample
  too_weak,      ///< it does not hold although the order is certified
  silent,        ///< it does not hold, and the order is not certified
  open           ///< it holds, and nothing else decides
};
[[nodiscard]] Comparison compare(const TheoremResult& theorem, const Smoothness& truth);

/// The statements of the literature about the family of this scheme, for its parameters; empty for
/// families without one. Cheap enough for every point of a map.
[[nodiscard]] std::vector<TheoremResult> theorems_for(const Scheme& scheme);

/// Property 1 of Shen and Huang ("mixtures of convergent difference schemes converge") where this
/// very scheme refutes it: its difference scheme is refuted, yet the mean of two that satisfy the
/// hypothesis and are proved convergent. Both are named in the remark. Nothing elsewhere.
[[nodiscard]] std::optional<TheoremResult> property_1_refuted_by(const Scheme& scheme);

}  // namespace arete
