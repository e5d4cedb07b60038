// SPDX-License-Identifier: MIT
#pragma once

#include "arete/analysis/joint_spectral_radius.h"
#include "arete/analysis/stability.h"
#include "arete/scheme/mask.h"

namespace arete {

/// Whether the limits have the critical Hoelder exponent itself, or only every smaller one.
enum class Attained { yes, no, unknown };

/// The critical Hoelder exponent of a scheme, alpha = -log_m JSR(q_N), N = number of sum rules and
/// a = (1 + ... + z^{m-1})^N q_N. With k = ceil(alpha) - 1 every limit is C^k and its k-th
/// derivative is Hoelder with every exponent below alpha - k (with alpha - k itself iff attained).
///
/// lower is always true of the limits. upper is a bound of the exponent only if the integer shifts
/// are stable (else the limits may be smoother). lower <= 0: not shown to converge. Both ends come
/// from exact bounds of the JSR; the logarithm is rounded outwards (by 1e-13), except that an
/// exponent proved to be an integer is that integer.
struct HoelderBounds {
  double lower = 0;
  double upper = 0;
  /// Three-valued: an integer alpha = n is attained iff the divided differences of order n stay
  /// bounded (exact norm), not if some word has a Jordan block there (exact ranks): the 4-point
  /// scheme is C^{2-eps} only. Otherwise it is attained iff the products are bounded at the JSR
  /// (irreducibility, an exact norm or an exact polytope show it).
  Attained attained = Attained::unknown;
  Stability stability = Stability::unknown;
  int sum_rules = 0;
  JsrBounds jsr;
};

[[nodiscard]] HoelderBounds hoelder_bounds(const Mask& mask, const JsrOptions& options = {});

/// -log_m of a positive rational, correct to about 1e-14 whatever its size.
[[nodiscard]] double negative_log(const Rational& value, int arity);

}  // namespace arete
