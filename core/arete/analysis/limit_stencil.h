// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "arete/scheme/mask.h"
#include "arete/scheme/stencil.h"

namespace arete {

/// Exact values of limits at old samples, with unit sample spacing.
///
/// With the basic limit function phi(x) = sum_k a_k phi(m x - k) the limit of data p_j is
/// f(x) = sum_j p_j phi(x - j), so the weight of p_j in f(0) is phi(-j), and in the derivative of
/// order d at 0 it is phi^(d)(-j). These weights w are the solution of
///
///     sum_j a_{m i - j} phi^(d)(j) = m^-d phi^(d)(i),   sum_j j^l w_j = (l == d ? d! : 0), l <= d
///
/// over the integers strictly inside the support [first, last]/(m - 1). "Sample 0" is at the
/// classical parameter 0; a dual scheme's new samples sit elsewhere (Mask::tau).
///
/// Nothing is returned where there is no such stencil or it cannot be had for sure:
/// - order 0 needs a certificate of C^0, order d one of C^d (certify with max_power 8);
/// - the equations must determine the weights (a multiple eigenvalue may leave them open);
/// - supports beyond largest_stencil_support samples, or numbers so long that exact elimination
///   would take more than some seconds, are refused.

inline constexpr int largest_stencil_support = 200;

/// The weights of f(0). Zero weights at both ends are trimmed.
[[nodiscard]] std::optional<Stencil> limit_stencil(const Mask& mask);

/// The weights of the derivative of this order at 0; order 0 is the limit itself.
/// \throws std::invalid_argument if order < 0.
[[nodiscard]] std::optional<Stencil> derivative_stencil(const Mask& mask, int order = 1);

}  // namespace arete
