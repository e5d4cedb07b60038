// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "arete/scheme/mask.h"

namespace arete {

/// How far limits can leave the range of their data. With Lambda = sup_x sum_j |phi(x - j)| the
/// limit of data in [lo, hi] stays in [lo - s (hi-lo), hi + s (hi-lo)], s = (Lambda - 1)/2; so
/// Lambda - 1 is the worst overshoot as a fraction of half the range. Lambda = 1 iff phi >= 0.
struct LimitNorm {
  Rational upper;  ///< Lambda <= upper, proved
  Rational level;  ///< ||S^levels||_inf, the same for the finite levels; tends to Lambda
  int levels = 0;
  /// s for `upper`: the fraction of the range by which a limit can overshoot at either side.
  /// Rounded up to nine decimals, so that it stays short and true.
  [[nodiscard]] Rational overshoot() const;
  /// The same for the tensor product of two such schemes (equal ones: surface_overshoot(other =
  /// *this)): the weights of a surface are products, so Lambda is, too.
  [[nodiscard]] Rational surface_overshoot(const LimitNorm& other) const;
};

/// A rigorous upper bound of Lambda, or nothing if none was found within the budget (then the
/// scheme may not even converge). For e = ||(1-z)^k a^[L]|| (the norm of the k-th differences after
/// L levels, k = 2 if two sum rules hold, else 1), the limit at any point is a convex combination
/// of two samples of level L (k = 2; one sample for k = 1) up to T e Lambda, where T counts how
/// many k-th differences lie inside the support; hence Lambda <= ||S^L|| / (1 - T e). The largest L
/// within the budget is used; the excess is O(m^{-min(alpha, k) L}).
[[nodiscard]] std::optional<LimitNorm> limit_norm(const Mask& mask,
                                                  std::int64_t work_budget = 4'000'000);

}  // namespace arete
