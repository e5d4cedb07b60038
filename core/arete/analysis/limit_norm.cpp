// SPDX-License-Identifier: MIT
#include "arete/analysis/limit_norm.h"

#include <algorithm>

#include "arete/analysis/certificate.h"
#include "arete/analysis/operator_power.h"
#include "arete/analysis/polynomial.h"

namespace arete {
namespace {

int largest_below(const Rational& x) { return static_cast<int>(ceil(x)) - 1; }

// How many differences of the order lie between the base samples and any sample that the limit at
// one point reads.
int count_of_differences(const Mask& mask, int order) {
  const int span = mask.arity() - 1;
  const Rational lowest = Rational(mask.first()) / span;
  const Rational highest = Rational(mask.last()) / span;
  // The base is at floor(y + offset): for linear data that is where the limit at y is read.
  const Rational offset =
      order == 2 ? Rational(-mask.tau() / span) : Rational(-(lowest + highest) / 2);
  const int right = std::max(0, largest_below(1 - offset - lowest));
  const int left = std::max(0, largest_below(offset + highest));
  return order == 2 ? std::max(right * (right - 1) / 2, left * (left + 1) / 2)
                    : std::max(right, left);
}

Rational rounded_up(const Rational& x) {
  constexpr int billion = 1'000'000'000;
  return Rational(ceil(x * billion)) / billion;
}

}  // namespace

Rational LimitNorm::overshoot() const { return rounded_up((upper - 1) / 2); }

Rational LimitNorm::surface_overshoot(const LimitNorm& other) const {
  return rounded_up((upper * other.upper - 1) / 2);
}

std::optional<LimitNorm> limit_norm(const Mask& mask, std::int64_t work_budget) {
  if (certify(mask, 8, work_budget).order < 0) return std::nullopt;
  if (step_norm(mask) == 1) return LimitNorm{1, 1, 1};  // no negative coefficient, phi >= 0
  const int order = sum_rules(mask) >= 2 ? 2 : 1;
  const int count = count_of_differences(mask, order);
  OperatorPower iterate(mask.arity(), mask.symbol());
  std::optional<LimitNorm> best;
  while (true) {
    const Rational rest = 1 - count * iterate.norm_of_differences(order);
    const Rational level = iterate.norm();
    if (rest > 0) {
      const Rational upper = level / rest;
      if (!best || upper < best->upper) best = LimitNorm{upper, level, iterate.power()};
    }
    const std::int64_t cost = iterate.cost_of_next();
    if (cost > work_budget || iterate.power() >= 12) break;
    work_budget -= cost;
    iterate.advance();
  }
  return best;
}

}  // namespace arete
