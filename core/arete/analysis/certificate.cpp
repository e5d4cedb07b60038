// SPDX-License-Identifier: MIT
#include "arete/analysis/certificate.h"

#include <utility>

#include "arete/analysis/operator_power.h"

namespace arete {
namespace {

Integer dilation_power(int arity, int exponent) {
  return boost::multiprecision::pow(Integer(arity), static_cast<unsigned>(exponent));
}

}  // namespace

std::optional<Rational> contractivity_norm(const Mask& mask, int order, int power,
                                           std::int64_t work_budget) {
  LaurentPolynomial<Rational> q = mask.symbol();
  for (int i = 0; i <= order; ++i) {
    auto quotient = q.divided_by_smoothing_factor(mask.arity());
    if (!quotient) return std::nullopt;
    q = *std::move(quotient);
  }
  OperatorPower iterate(mask.arity(), q);
  while (iterate.power() < power) {
    const std::int64_t cost = iterate.cost_of_next();
    if (cost > work_budget) return std::nullopt;
    work_budget -= cost;
    iterate.advance();
  }
  return iterate.norm() * Rational(dilation_power(mask.arity(), order * power));
}

Certificate certify(const Mask& mask, int max_power, std::int64_t work_budget, const Stop& stop) {
  Certificate certificate;
  auto q = mask.symbol().divided_by_smoothing_factor(mask.arity());
  while (q) {
    const int order = certificate.sum_rules++;
    OperatorPower iterate(mask.arity(), *q);
    while (true) {
      const Rational norm =
          iterate.norm() * Rational(dilation_power(mask.arity(), order * iterate.power()));
      if (norm < 1) {
        certificate.proofs.push_back({order, iterate.power(), norm});
        break;
      }
      if (iterate.power() >= max_power) break;
      const std::int64_t cost = iterate.cost_of_next();
      if (cost > work_budget || must_stop(stop)) {
        certificate.exhausted = true;
        break;
      }
      work_budget -= cost;
      iterate.advance();
    }
    q = q->divided_by_smoothing_factor(mask.arity());
  }
  if (!certificate.proofs.empty()) {
    const OrderProof& best = certificate.proofs.back();
    certificate.order = best.order;
    certificate.power = best.power;
    certificate.norm = best.norm;
  }
  return certificate;
}

}  // namespace arete
