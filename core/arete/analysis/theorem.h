// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "arete/analysis/smoothness.h"
#include "arete/scheme/scheme.h"

namespace arete {

/// A published smoothness statement in its own form, evaluated for given parameters. It "holds" if
/// its printed hypothesis is met: every value < 1 and every residual = 0.
struct TheoremResult {
  std::string name;       ///< `theorem 2 (Zhao, Peng, Ye)`
  std::string statement;  ///< the printed condition, one line
  int claims = 0;         ///< the order of smoothness that it promises where it holds
  bool holds = false;
  std::vector<Rational> values;     ///< what must be below 1
  std::vector<Rational> residuals;  ///< what must vanish
  bool sound = true;   ///< whether the statement itself is true (two of the published ones are not)
  std::string remark;  ///< what is true instead, where it is not sound; otherwise may be empty
};

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
/// families without one.
[[nodiscard]] std::vector<TheoremResult> theorems_for(const Scheme& scheme);

}  // namespace arete
