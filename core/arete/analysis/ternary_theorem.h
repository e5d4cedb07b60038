// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "arete/analysis/theorem.h"

namespace arete {

/// Theorem 3.1 of Zhong, Qi ("Parameterized ternary two-step interpolatory subdivision scheme"):
/// the ternary scheme is C^n, n = 0, 1, 2, for b in the printed interval. True; the intervals are
/// what the second power of (1/3) S_{n+1} certifies, neither sharp nor what larger powers give.
struct TernaryInterval {
  int order = 0;
  Rational printed_lower;
  Rational printed_upper;
  /// Quadratics with integer coefficients (constant term first) whose root is the exact end point:
  /// where the norm of the second power becomes 1.
  std::array<int, 3> lower_root_of;
  std::array<int, 3> upper_root_of;
};
[[nodiscard]] const std::array<TernaryInterval, 3>& ternary_intervals();

/// The theorem for one b: for each n the exact norm ||((1/3) S_{n+1})^2||.
[[nodiscard]] std::vector<TheoremResult> ternary_results(const Rational& b);

}  // namespace arete
