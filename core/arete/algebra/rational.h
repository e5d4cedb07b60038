// SPDX-License-Identifier: MIT
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <string>
#include <string_view>

namespace arete {

/// An integer of any size.
using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>,
                                              boost::multiprecision::et_off>;

/// An exact quotient of two integers of any size, always reduced, denominator > 0.
/// Expression templates are off so that it behaves as any other coefficient ring in a template.
using Rational = boost::multiprecision::number<
    boost::multiprecision::rational_adaptor<boost::multiprecision::cpp_int_backend<>>,
    boost::multiprecision::et_off>;

/// Reads `7`, `-7/32`, `0.0625`, `1e-3`, `-2.5E+2`; a decimal is taken exactly (0.1 is 1/10).
/// Surrounding blanks are allowed, nothing else is.
/// \throws std::invalid_argument naming the text if it is not such a number, its denominator is
/// zero, or its exponent is beyond +-400 (no double has more).
[[nodiscard]] Rational parse_rational(std::string_view text);

/// `7` or `-7/32`; parse_rational(to_string(x)) == x.
[[nodiscard]] std::string to_string(const Rational& value);

/// The double nearest to `value`.
[[nodiscard]] double to_double(const Rational& value);

/// Largest integer not above `value`.
[[nodiscard]] Integer floor(const Rational& value);

/// Smallest integer not below `value`.
[[nodiscard]] Integer ceil(const Rational& value);

[[nodiscard]] inline bool is_integer(const Rational& value) {
  return boost::multiprecision::denominator(value) == 1;
}

/// base^exponent for exponent >= 0; 0^0 = 1.
[[nodiscard]] Rational power(const Rational& base, unsigned exponent);

}  // namespace arete
