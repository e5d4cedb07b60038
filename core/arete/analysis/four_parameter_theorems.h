// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "arete/analysis/theorem.h"

namespace arete {

/// Theorems 1-3 of Zhao, Peng, Ye ("Improved four points subdivision scheme and its applications")
/// in their printed form. All three are true; as tests of the first power they are weak (theorem 2
/// certifies no 4-point scheme of Dyn, Gregory and Levin). l = lambda, m = mu, n = nu, w = omega:
///
///     1 (C^0): max{ |2wn| + |1/2-l+2w-4wn| + |2w+m-2wn|, |l+2wn| + |1/2-2w-m+4wn| + |2w(1-n)| } <
///     1 2 (C^1): m-l+4w-8wn = 0,
///              2 max{ |2wn|+|1/2-2l+2w-8wn|+|2w-2wn|, |l+4wn|+|2l-m-4w+12wn| } < 1
///     3 (C^2): in addition -1/2-m-4w+5l+24wn = 0,
///              4 max{ |2wn|+|1/2-3l+2w-14wn|, |l+6wn|+|2w-2wn| } < 1
///
/// The values are given whether or not the residuals vanish.
struct FourParameterTheorems {
  Rational theorem1_value;
  Rational theorem2_value;
  Rational theorem2_residual;
  Rational theorem3_value;
  std::array<Rational, 2> theorem3_residuals;
};

[[nodiscard]] FourParameterTheorems four_parameter_theorems(const Rational& lambda,
                                                            const Rational& mu, const Rational& nu,
                                                            const Rational& omega);

/// The same as three results.
[[nodiscard]] std::vector<TheoremResult> four_parameter_results(const Rational& lambda,
                                                                const Rational& mu,
                                                                const Rational& nu,
                                                                const Rational& omega);

}  // namespace arete
