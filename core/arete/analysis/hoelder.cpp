// SPDX-License-Identifier: MIT
#include "arete/analysis/hoelder.h"

#include <cmath>
#include <limits>

#include "arete/algebra/linear_solve.h"
#include "arete/analysis/operator_power.h"

namespace arete {
namespace {

constexpr double outwards = 1e-13;
constexpr int tried_powers = 4;
constexpr std::int64_t tried_work = 200'000;
constexpr int largest_ranked = 24;

// n with value = m^-n, if there is one.
std::optional<int> integer_exponent(const Rational& value, int arity) {
  const int n = static_cast<int>(std::lround(negative_log(value, arity)));
  const Rational power_of_m = power(Rational(arity), static_cast<unsigned>(std::abs(n)));
  return value == (n >= 0 ? Rational(1) / power_of_m : power_of_m) ? std::optional(n)
                                                                   : std::nullopt;
}

bool is_defective(const LocalMatrices& local, const Word& word, const Rational& eigenvalue) {
  Matrix<Rational> shifted = word_product(local, word);
  for (int i = 0; i < local.size; ++i) shifted(i, i) -= eigenvalue;
  return exact_rank(shifted * shifted) < exact_rank(shifted);
}

// Are the differences of order n, n = alpha, bounded by m^{-n level}?
Attained attained_integer(const Mask& mask, const FactoredMask& parts, int n, const Word& word) {
  if (n < 0 || n > parts.rules) return Attained::unknown;
  const int m = mask.arity();
  const auto q = parts.rest * power(smoothing_factor<Rational>(m), parts.rules - n);
  OperatorPower iterate(m, q);
  std::int64_t budget = tried_work;
  for (int tried = 1; tried <= tried_powers; ++tried) {
    if (iterate.norm() * power(Rational(m), static_cast<unsigned>(n * tried)) <= 1)
      return Attained::yes;
    budget -= iterate.cost_of_next();
    if (budget < 0) break;
    iterate.advance();
  }
  const LocalMatrices local = local_matrices(m, q);
  if (local.size > largest_ranked) return Attained::unknown;
  std::vector<Word> words;
  for (int digit = 0; digit < m; ++digit) words.push_back({digit});
  if (!word.empty()) words.push_back(word);
  for (const Word& candidate : words) {
    const Rational value =
        Rational(1) /
        power(Rational(m), static_cast<unsigned>(n * static_cast<int>(candidate.size())));
    if (is_defective(local, candidate, value) || is_defective(local, candidate, -value))
      return Attained::no;
  }
  return Attained::unknown;
}

}  // namespace

double negative_log(const Rational& value, int arity) {
  const Integer top = boost::multiprecision::numerator(value);
  const Integer bottom = boost::multiprecision::denominator(value);
  if (top <= 0) return std::numeric_limits<double>::infinity();
  // An integer quotient of some 80 bits, so that no size can overflow a double.
  const int shift = 80 - (static_cast<int>(msb(top)) - static_cast<int>(msb(bottom)));
  const Integer quotient =
      shift >= 0 ? Integer((top << shift) / bottom) : Integer(top / (bottom << -shift));
  const double log_value = std::log(quotient.convert_to<double>()) - shift * std::log(2.0);
  return -log_value / std::log(static_cast<double>(arity));
}

HoelderBounds hoelder_bounds(const Mask& mask, const JsrOptions& options) {
  const FactoredMask parts = factored(mask);
  HoelderBounds result;
  result.sum_rules = parts.rules;
  if (!must_stop(options.stop)) result.stability = shift_stability(mask);
  result.jsr = joint_spectral_radius(mask.arity(), parts.rest, options);
  if (result.jsr.exact) {
    if (const auto n = integer_exponent(*result.jsr.exact, mask.arity())) {
      result.lower = result.upper = *n;
      if (!must_stop(options.stop))
        result.attained = attained_integer(mask, parts, *n, result.jsr.word);
      const bool unsure = result.attained == Attained::no && result.stability != Stability::stable;
      if (unsure || *n <= 0) result.attained = Attained::unknown;
      return result;
    }
  }
  result.lower = negative_log(result.jsr.upper, mask.arity()) - outwards;
  result.upper = negative_log(result.jsr.lower, mask.arity()) + outwards;
  const bool holds_no_integer = std::floor(result.lower) == std::floor(result.upper) &&
                                std::floor(result.lower) < result.lower;
  if (result.lower > 0 && result.jsr.bounded && (holds_no_integer || result.jsr.exact))
    result.attained = Attained::yes;
  return result;
}

}  // namespace arete
