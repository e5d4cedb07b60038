// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "arete/reverse/reverse_level.h"

namespace arete {

/// The anchors of a level: as many fine samples as there are coarse ones (their places in order,
/// from 0) whose rows of S form an invertible matrix. Of a least-squares residual e, with S^T e =
/// 0, the anchors' part follows from the rest, so only the rest is kept as details.
///
/// The anchors are the samples of one phase, best the one whose symbol stays farthest from zero on
/// the unit circle. Where the symbol turns around zero w times, row q of the phase belongs to
/// column q + w (otherwise the inverse of a long open axis would grow like a geometric series;
/// Gohberg and Feldman, Convolution Equations, 1974). Rows that would lie beyond an end of an open
/// axis are replaced by others near that end, chosen so that rounding errors are amplified least.
/// The choice depends on the mask and the sizes only.
///
/// \throws InvalidScheme if every phase's symbol vanishes somewhere on the circle.
[[nodiscard]] std::vector<Index> anchor_rows(const Mask& mask, const ReverseLevel& level,
                                             Boundary boundary);

}  // namespace arete
