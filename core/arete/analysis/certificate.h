// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "arete/analysis/stop.h"
#include "arete/scheme/mask.h"

namespace arete {

/// One proof of smoothness: the limit functions of the scheme are C^order because
///
///     (1 + z + ... + z^{m-1})^{order+1} divides the symbol and norm < 1,
///     norm = || ((1/m) S_{order+1})^power ||_inf = m^{order power} || S_q^power ||_inf,
///
/// where q = a / (1 + ... + z^{m-1})^{order+1} is the mask of the undivided differences of that
/// order, S_q^L has the symbol q(z) q(z^m) ... q(z^{m^{L-1}}) and its norm is the largest absolute
/// row sum, over residues modulo m^L (Dyn 1992; Dyn, Levin, "Subdivision schemes in geometric
/// modelling", Acta Numerica 2002, for binary schemes).
struct OrderProof {
  int order = 0;
  int power = 1;
  Rational norm;
};

/// All that norms of powers prove. "Not certified" never means "not smooth": see refutation.h.
struct Certificate {
  int order = -1;  ///< largest proved order; -1: not even uniform convergence was proved
  int power = 0;   ///< the power of that order's proof, 0 if there is none
  Rational norm;   ///< the exact norm of that order's proof, 0 if there is none
  int sum_rules = 0;
  std::vector<OrderProof> proofs;  ///< every proved order, ascending, each with its smallest power
  bool exhausted = false;          ///< some order was not tried up to max_power: the budget ran out
};

/// Limits the number of word-sized multiplications, so that the answer does not depend on the
/// machine: about two seconds at the default.
inline constexpr std::int64_t default_work_budget = 8'000'000;

/// The exact norm of the definition above; nothing if order + 1 sum rules do not hold or if the
/// work would exceed the budget. order >= 0, power >= 1.
[[nodiscard]] std::optional<Rational> contractivity_norm(
    const Mask& mask, int order, int power, std::int64_t work_budget = default_work_budget);

/// Tries every order below the number of sum rules with the powers 1..max_power.
/// Exact rational arithmetic throughout; the cost grows as m^max_power times the number of taps
/// squared, bounded by the budget; `stop` ends it as an empty budget does.
[[nodiscard]] Certificate certify(const Mask& mask, int max_power = 8,
                                  std::int64_t work_budget = default_work_budget,
                                  const Stop& stop = {});

}  // namespace arete
