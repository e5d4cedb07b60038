// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "arete/algebra/rational.h"

namespace arete::prime_field {

/// Residues modulo the prime 2^31 - 1, whose products fit 64 bits. A rank or a degree that is
/// already right modulo a prime proves it over the rationals, at a fraction of the cost.
inline constexpr std::uint64_t prime = (std::uint64_t{1} << 31) - 1;

/// 1/a for a != 0 (Fermat).
[[nodiscard]] inline std::uint64_t inverse(std::uint64_t a) {
  std::uint64_t result = 1;
  for (std::uint64_t e = prime - 2; e != 0; e >>= 1) {
    if (e & 1) result = result * a % prime;
    a = a * a % prime;
  }
  return result;
}

[[nodiscard]] inline std::uint64_t residue(const Integer& value) {
  Integer rest = value % Integer(prime);
  if (rest < 0) rest += prime;
  return rest.convert_to<std::uint64_t>();
}

/// Nothing if the prime divides the denominator.
[[nodiscard]] inline std::optional<std::uint64_t> residue(const Rational& value) {
  const std::uint64_t bottom = residue(Integer(boost::multiprecision::denominator(value)));
  if (bottom == 0) return std::nullopt;
  return residue(Integer(boost::multiprecision::numerator(value))) * inverse(bottom) % prime;
}

}  // namespace arete::prime_field
