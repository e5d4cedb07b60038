// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "arete/algebra/laurent_polynomial.h"
#include "arete/algebra/rational.h"
#include "arete/field/grid.h"

namespace arete {

/// Smallest and largest index of a run of samples, both included; empty when first > last.
struct IndexRange {
  Index first = 0;
  Index last = -1;

  [[nodiscard]] Index count() const { return last < first ? 0 : last - first + 1; }
  [[nodiscard]] friend bool operator==(const IndexRange&, const IndexRange&) = default;
};

[[nodiscard]] inline Index floor_divide(Index a, Index b) {
  return a / b - (a % b != 0 && (a % b < 0) != (b < 0) ? 1 : 0);
}
[[nodiscard]] inline Index ceil_divide(Index a, Index b) { return -floor_divide(-a, b); }

/// What takes the samples of one level to the next along one axis:
///
///     q_k = sum_j a_{k - m j} p_j     with arity m >= 1.
///
/// m >= 2 is a step of a subdivision scheme; m = 1 is a plain filter (limit positions, or one phase
/// of a scheme where only every m-th new sample is wanted).
struct LevelRule {
  int arity = 1;
  LaurentPolynomial<Rational> symbol;

  /// The samples of the level before that `fine` reads.
  [[nodiscard]] IndexRange needed(IndexRange fine) const {
    return {ceil_divide(fine.first - symbol.highest(), arity),
            floor_divide(fine.last - symbol.lowest(), arity)};
  }

  /// The new samples whose whole stencil (the mask's, zeros inside it included) lies in `coarse`.
  [[nodiscard]] IndexRange computable(IndexRange coarse) const {
    return {arity * (coarse.first - 1) + symbol.highest() + 1,
            arity * (coarse.last + 1) + symbol.lowest() - 1};
  }
};

/// The stencil of one phase r: the new sample k = m q + r is sum_i weights[i] p_{q + first + i}.
template <class T>
struct PhaseStencil {
  Index first = 0;
  std::vector<T> weights;
};

/// A rule with its weights in the arithmetic of the samples, sorted by phase.
template <class T>
struct PhasedRule {
  int arity = 1;
  std::vector<PhaseStencil<T>> phases;

  explicit PhasedRule(const LevelRule& rule) : arity(rule.arity) {
    for (int r = 0; r < arity; ++r) {
      // a_{m q + r - m j} with j = q + d is a_{r - m d}; d ascending, zeros at both ends left out.
      PhaseStencil<T> phase;
      const Index lowest = ceil_divide(r - rule.symbol.highest(), arity);
      const Index highest = floor_divide(r - rule.symbol.lowest(), arity);
      for (Index d = lowest; d <= highest; ++d) {
        const Rational weight = rule.symbol[static_cast<int>(r - arity * d)];
        if (weight == 0 && phase.weights.empty()) continue;
        if (phase.weights.empty()) phase.first = d;
        phase.weights.push_back(weight.convert_to<T>());
      }
      while (!phase.weights.empty() && phase.weights.back() == T(0)) phase.weights.pop_back();
      phases.push_back(std::move(phase));
    }
  }
};

}  // namespace arete
