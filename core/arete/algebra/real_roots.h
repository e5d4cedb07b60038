// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "arete/algebra/prime_field.h"
#include "arete/algebra/rational.h"

namespace arete {

/// Dense polynomials over the rationals, coefficients ascending, no zero at the high end; the zero
/// polynomial is empty. Only what exact root counting needs.
using Coefficients = std::vector<Rational>;

[[nodiscard]] inline Coefficients trimmed(Coefficients p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
  return p;
}

[[nodiscard]] inline Rational value_at(const Coefficients& p, const Rational& x) {
  Rational value = 0;
  for (auto c = p.rbegin(); c != p.rend(); ++c) value = value * x + *c;
  return value;
}

/// (x - r_1) (x - r_2) ...
[[nodiscard]] inline Coefficients monic_polynomial(const std::vector<Rational>& roots) {
  Coefficients product = {1};
  for (const Rational& root : roots) {
    product.insert(product.begin(), Rational(0));
    for (std::size_t i = 0; i + 1 < product.size(); ++i) product[i] -= root * product[i + 1];
  }
  return product;
}

[[nodiscard]] inline Coefficients derivative_of(const Coefficients& p) {
  Coefficients result;
  for (std::size_t i = 1; i < p.size(); ++i) result.push_back(p[i] * static_cast<int>(i));
  return result;
}

/// a = quotient b + remainder with the degree of the remainder below that of b (not zero).
struct Division {
  Coefficients quotient;
  Coefficients remainder;
};
[[nodiscard]] inline Division divided(Coefficients a, const Coefficients& b) {
  Division result;
  if (a.size() >= b.size()) result.quotient.assign(a.size() - b.size() + 1, Rational(0));
  for (std::size_t i = result.quotient.size(); i-- > 0;) {
    const Rational factor = a[i + b.size() - 1] / b.back();
    if (factor != 0)
      for (std::size_t j = 0; j < b.size(); ++j) a[i + j] -= factor * b[j];
    result.quotient[i] = factor;
  }
  result.remainder = trimmed(std::move(a));
  return result;
}

/// p divided by the positive number that makes its coefficients integers without common factor:
/// keeps signs, keeps remainder sequences short.
[[nodiscard]] inline Coefficients primitive_part(Coefficients p) {
  if (p.empty()) return p;
  Integer numerator = 0;
  Integer denominator = 1;
  for (const Rational& c : p) {
    numerator = boost::multiprecision::gcd(numerator, boost::multiprecision::numerator(c));
    denominator = boost::multiprecision::lcm(denominator, boost::multiprecision::denominator(c));
  }
  const Rational content(abs(numerator), denominator);
  for (Rational& c : p) c /= content;
  return p;
}

/// Whether a and b have no common root at all, shown by a gcd of degree 0 modulo a prime that
/// divides no denominator nor the leading coefficient of a. False means: not shown.
[[nodiscard]] inline bool coprime_modulo_a_prime(const Coefficients& a, const Coefficients& b) {
  using prime_field::inverse;
  using prime_field::prime;
  std::vector<std::uint64_t> remainders[2];
  for (int which = 0; which < 2; ++which)
    for (const Rational& c : which == 0 ? a : b) {
      const auto value = prime_field::residue(c);
      if (!value) return false;
      remainders[which].push_back(*value);
    }
  if (a.empty() || b.empty() || remainders[0].back() == 0) return false;
  auto& [x, y] = remainders;
  const auto trim = [](std::vector<std::uint64_t>& p) {
    while (!p.empty() && p.back() == 0) p.pop_back();
  };
  trim(y);
  while (!y.empty()) {
    const std::uint64_t scale = inverse(y.back());
    while (x.size() >= y.size()) {
      const std::uint64_t factor = x.back() * scale % prime;
      const std::size_t offset = x.size() - y.size();
      for (std::size_t i = 0; i < y.size(); ++i)
        x[offset + i] = (x[offset + i] + (prime - factor) * y[i]) % prime;
      trim(x);
    }
    std::swap(x, y);
  }
  return x.size() == 1;
}

/// A greatest common divisor (primitive, sign of the leading coefficient arbitrary).
[[nodiscard]] inline Coefficients gcd_of(Coefficients a, Coefficients b) {
  if (coprime_modulo_a_prime(a, b)) return {1};
  while (!b.empty()) {
    Coefficients rest = primitive_part(divided(std::move(a), b).remainder);
    a = std::move(b);
    b = std::move(rest);
  }
  return primitive_part(std::move(a));
}

/// The number of distinct real roots of p (not zero) in the closed interval [lowest, highest], by
/// Sturm's theorem. Exact.
[[nodiscard]] inline int distinct_real_roots(const Coefficients& p, const Rational& lowest,
                                             const Rational& highest) {
  const Coefficients simple = primitive_part(
      divided(p, gcd_of(p, derivative_of(p))).quotient);  // the same roots, once each
  std::vector<Coefficients> chain = {simple, primitive_part(derivative_of(simple))};
  while (!chain.back().empty()) {
    Coefficients rest = primitive_part(divided(chain[chain.size() - 2], chain.back()).remainder);
    for (Rational& c : rest) c = -c;
    chain.push_back(std::move(rest));
  }
  const auto variations = [&chain](const Rational& x) {
    int changes = 0;
    int previous = 0;
    for (const Coefficients& member : chain) {
      const int sign = value_at(member, x).sign();
      if (sign != 0 && previous != 0 && sign != previous) ++changes;
      if (sign != 0) previous = sign;
    }
    return changes;
  };
  // Sturm counts the half-open interval (lowest, highest]. Roots at its ends do no harm: the
  // polynomial is square-free, and the variations ignore zeros.
  const int at_lowest = value_at(simple, lowest) == 0 ? 1 : 0;
  return variations(lowest) - variations(highest) + at_lowest;
}

}  // namespace arete
