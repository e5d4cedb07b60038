// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "arete/algebra/rational.h"

namespace arete {

/// Exact weights on neighbouring samples: the value at i is sum_k weights[k] p_{i + first + k}.
/// Limit and derivative stencils are of this kind.
struct Stencil {
  int first = 0;
  std::vector<Rational> weights;

  [[nodiscard]] int last() const { return first + static_cast<int>(weights.size()) - 1; }
  [[nodiscard]] friend bool operator==(const Stencil&, const Stencil&) = default;
};

}  // namespace arete
