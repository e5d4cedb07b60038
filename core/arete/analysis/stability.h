// SPDX-License-Identifier: MIT
#pragma once

#include "arete/scheme/mask.h"

namespace arete {

/// Whether the integer shifts of the basic limit function phi are stable (no xi with
/// phi^(xi + 2 pi k) = 0 for all integers k). Then smoothness is decided by the mask alone: a C^k
/// limit needs k + 1 sum rules, and -log_m JSR is the Hoelder exponent itself, not only a lower
/// bound.
enum class Stability { stable, unstable, unknown };

/// Decided exactly from the mask a (Jia, Wang, "Stability and linear independence associated with
/// wavelet decompositions", 1993, for m = 2; the same argument for every m). Unstable iff one of
/// - a vanishes at all m points with the same m-th power, for some point on the unit circle: the
///   polyphase parts have a common root there (gcd and Sturm's theorem);
/// - for some n > 1 prime to m the mask vanishes at every m-th-power preimage of the primitive n-th
///   roots of unity that is not itself one: Phi_n(z^m) divides Phi_n(z) a(z).
/// The second needs phi(n) (m-1) <= degree, so finitely many n. `unknown` only for masks with more
/// than 1200 coefficients, which are not tried.
[[nodiscard]] Stability shift_stability(const Mask& mask);

}  // namespace arete
