// SPDX-License-Identifier: MIT
#pragma once

#include "arete/scheme/mask.h"

namespace arete {

/// What a scheme does to polynomial data. All answers are exact.

/// The number of sum rules: the largest k such that (1 + z + ... + z^{m-1})^k divides the symbol.
/// At least 1 for every Mask (its phases sum to 1). k sum rules mean that the scheme *generates*
/// polynomials of degree k - 1: polynomial data of degree < k have polynomial limits.
[[nodiscard]] int sum_rules(const Mask& mask);

/// The largest d such that every polynomial p of degree <= d is reproduced: data p(j) give the
/// limit p(x - t) for one shift t. At least 0. Reproduction of degree d needs d + 1 sum rules and
///
///     a^(k)(1) = m prod_{l<k} (tau - l)   for k = 0..d,   tau = a'(1)/m
///
/// (Conti, Hormann, "Polynomial reproduction for univariate subdivision schemes of any arity").
[[nodiscard]] int reproduction_degree(const Mask& mask);

/// Whether old samples stay: some phase is a unit impulse, i.e. there is an s with a_s = 1 and
/// a_{s + m k} = 0 for all k != 0. The old sample j is then found at the new index s + m j.
[[nodiscard]] bool is_interpolatory(const Mask& mask);

/// The largest absolute row sum of one step, max over phases r of sum_k |a_{r + m k}|; at least 1.
[[nodiscard]] Rational step_norm(const Mask& mask);

/// How far one level can leave the range of its input, as a fraction of that range:
/// (step_norm - 1)/2. Zero exactly for masks without negative coefficients. With lowest input lo
/// and highest hi, one level stays in [lo - s (hi - lo), hi + s (hi - lo)].
[[nodiscard]] Rational overshoot(const Mask& mask);

}  // namespace arete
