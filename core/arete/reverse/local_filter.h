// SPDX-License-Identifier: MIT
#pragma once

#include "arete/refine/level_rule.h"
#include "arete/scheme/mask.h"
#include "arete/scheme/stencil.h"

namespace arete {

/// The shortest-norm exact filter on a window: weights w on the fine samples window.first.. with
/// sum_k w_k f_k = c_0 whenever f is refined from c (first = window.first). It is row 0 of the
/// pseudo-inverse of the window's part of S, so of all such filters it amplifies noise least; as
/// the window grows it tends to the least-squares reverse.
///
///     chaikin -2..1: (-1, 3, 3, -1)/4       cubic B-spline -1..1: (-1, 4, -1)/2
///
/// Exact; O(window^3). \throws InvalidScheme if the window does not determine every coarse sample
/// it reads (make it longer or shift it).
[[nodiscard]] Stencil local_filter(const Mask& mask, IndexRange window);

}  // namespace arete
