// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "arete/scheme/mask.h"

namespace arete {

/// Samples of a function at first, first + spacing, ...
struct BasisSamples {
  double first = 0;
  double spacing = 1;
  std::vector<double> values;
};

/// The basic limit function phi(x) = sum_k a_k phi(m x - k) (the limit of the impulse at 0, sample
/// spacing 1), or a derivative of it, as finitely many levels give it: at least `least` samples
/// over the whole support [first, last]/(m - 1), zeros at both ends included.
///
/// phi^(k)(x) = sum_j d_j phi_k(x - j) with d the k-th differences of the impulse and phi_k the
/// basic limit function of the derived scheme m^k a(z)/(1 + ... + z^{m-1})^k; refining d with that
/// scheme is stable, where differences of fine samples would be rounding only. The samples tend to
/// phi^(k) where the scheme is certified C^k; otherwise they are what they are. \throws
/// std::invalid_argument if order < 0 or fewer than `order` sum rules hold. Cost O(least + support
/// m) taps.
[[nodiscard]] BasisSamples basis_function(const Mask& mask, int order = 0, int least = 1500);

}  // namespace arete
