// SPDX-License-Identifier: MIT
#include "arete/analysis/operator_power.h"

#include <algorithm>

namespace arete {
namespace {

std::int64_t words(const Integer& value) {
  return value == 0 ? 1 : static_cast<std::int64_t>(msb(abs(value))) / 64 + 1;
}

std::int64_t words(const std::vector<Integer>& values) {
  std::int64_t most = 1;
  for (const Integer& value : values) most = std::max(most, words(value));
  return most;
}

}  // namespace

OperatorPower::OperatorPower(int arity, const LaurentPolynomial<Rational>& q)
    : arity_(arity), dilation_(arity), denominator_(1) {
  for (const Rational& c : q.coefficients())
    denominator_ = lcm(denominator_, boost::multiprecision::denominator(c));
  for (const Rational& c : q.coefficients())
    factor_.push_back(boost::multiprecision::numerator(c) *
                      (denominator_ / boost::multiprecision::denominator(c)));
  product_ = factor_;
  scale_ = denominator_;
}

std::int64_t OperatorPower::cost_of_next() const {
  const auto size = static_cast<double>(product_.size());
  const auto taps = static_cast<double>(factor_.size());
  const double cost = size * taps * static_cast<double>(words(product_) * words(factor_)) +
                      taps * static_cast<double>(dilation_);
  return cost > 9e18 ? INT64_MAX : static_cast<std::int64_t>(cost);
}

void OperatorPower::advance() {
  if (factor_.empty()) {
    ++power_;
    return;
  }
  // The largest dilation reached is bounded by the caller's budget on cost_of_next.
  const auto step = static_cast<std::size_t>(dilation_);
  std::vector<Integer> next(product_.size() + (factor_.size() - 1) * step, Integer(0));
  for (std::size_t j = 0; j < factor_.size(); ++j) {
    if (factor_[j] == 0) continue;
    for (std::size_t i = 0; i < product_.size(); ++i)
      next[i + j * step] += product_[i] * factor_[j];
  }
  product_ = std::move(next);
  scale_ *= denominator_;
  dilation_ *= arity_;
  ++power_;
}

Rational OperatorPower::norm_of_differences(int order) const {
  if (product_.empty()) return 0;
  std::vector<Integer> differences;
  for (int k = 0; k < order; ++k) {
    if (k == 0) differences = product_;
    differences.emplace_back(0);
    for (std::size_t i = differences.size(); i-- > 1;) differences[i] -= differences[i - 1];
  }
  const std::vector<Integer>& symbol = order == 0 ? product_ : differences;
  const auto residues = std::min(symbol.size(), static_cast<std::size_t>(dilation_));
  Integer most = 0;
  for (std::size_t r = 0; r < residues; ++r) {
    Integer sum = 0;
    for (std::size_t i = r; i < symbol.size(); i += static_cast<std::size_t>(dilation_))
      sum += abs(symbol[i]);
    if (sum > most) most = sum;
  }
  return Rational(most, scale_);
}

}  // namespace arete
