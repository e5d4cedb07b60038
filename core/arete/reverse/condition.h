// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "arete/reverse/axis_reverse.h"

namespace arete {

/// How errors of fine samples reach the coarse ones, one level, far from any end. They multiply
/// from level to level.
struct ReverseCondition {
  /// Root mean square error of the coarse samples for white noise of size 1 on the fine ones.
  double noise_gain = 0;
  /// |S| |A| in the Euclidean norm, S the subdivision, A the analysis filter: how much more the
  /// relative error of the coarse samples can be than that of the fine ones, at worst.
  double condition = 0;
};

/// With the phases a_r of the symbol and |a(w)|^2 = sum_r |a_r(e^iw)|^2: |S| = max |a|; least
/// squares have |A| = 1/min |a| and noise_gain^2 = mean 1/|a|^2; a local filter h has |A| = max |h|
/// and noise_gain^2 = sum of its squared weights. Nothing if the scheme has no reverse in that
/// mode.
[[nodiscard]] std::optional<ReverseCondition> reverse_condition(const Mask& mask, ReverseMode mode);

}  // namespace arete
