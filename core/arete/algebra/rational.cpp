// SPDX-License-Identifier: MIT
#include "arete/algebra/rational.h"

#include <charconv>
#include <stdexcept>

namespace arete {
namespace {

constexpr int largest_exponent = 400;
constexpr std::size_t longest_number = 4000;

[[noreturn]] void reject(std::string_view text, const char* why) {
  throw std::invalid_argument("'" + std::string(text) + "' " + why);
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

bool all_digits(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

// cpp_int's own string constructor would read a leading 0 as octal.
Integer digits_to_integer(std::string_view digits) {
  const auto first = digits.find_first_not_of('0');
  if (first == std::string_view::npos) return 0;
  return Integer(std::string(digits.substr(first)));
}

Rational parse_unsigned_decimal(std::string_view whole, std::string_view body) {
  int exponent = 0;
  if (const auto mark = body.find_first_of("eE"); mark != std::string_view::npos) {
    auto tail = body.substr(mark + 1);
    if (!tail.empty() && tail.front() == '+') tail.remove_prefix(1);
    const auto [end, error] = std::from_chars(tail.data(), tail.data() + tail.size(), exponent);
    if (error != std::errc{} || end != tail.data() + tail.size())
      reject(whole, "is not a number; its exponent is not an integer");
    if (exponent > largest_exponent || exponent < -largest_exponent)
      reject(whole, "has an exponent beyond 400");
    body = body.substr(0, mark);
  }
  std::string digits(body);
  if (const auto point = digits.find('.'); point != std::string::npos) {
    exponent -= static_cast<int>(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  if (!all_digits(digits)) reject(whole, "is not a number; write 7, -7/32 or 0.0625");
  Rational value(digits_to_integer(digits));
  const Integer scale =
      boost::multiprecision::pow(Integer(10), exponent < 0 ? -exponent : exponent);
  return exponent < 0 ? value / Rational(scale) : value * Rational(scale);
}

}  // namespace

Rational parse_rational(std::string_view text) {
  const std::string_view whole = trimmed(text);
  if (whole.size() > longest_number) reject(whole.substr(0, 40), "... is too long for a number");
  std::string_view body = whole;
  bool negative = false;
  if (!body.empty() && (body.front() == '-' || body.front() == '+')) {
    negative = body.front() == '-';
    body.remove_prefix(1);
  }
  Rational value;
  if (const auto slash = body.find('/'); slash != std::string_view::npos) {
    const auto numerator = body.substr(0, slash);
    const auto denominator = body.substr(slash + 1);
    if (!all_digits(numerator) || !all_digits(denominator))
      reject(whole, "is not a number; write 7, -7/32 or 0.0625");
    const Integer divisor = digits_to_integer(denominator);
    if (divisor == 0) reject(whole, "has denominator zero");
    value = Rational(digits_to_integer(numerator), divisor);
  } else {
    value = parse_unsigned_decimal(whole, body);
  }
  return negative ? Rational(-value) : value;
}

std::string to_string(const Rational& value) { return value.str(); }

double to_double(const Rational& value) { return value.convert_to<double>(); }

Integer floor(const Rational& value) {
  const Integer numerator = boost::multiprecision::numerator(value);
  const Integer denominator = boost::multiprecision::denominator(value);
  Integer quotient = numerator / denominator;
  if (numerator < 0 && quotient * denominator != numerator) quotient -= 1;
  return quotient;
}

Integer ceil(const Rational& value) { return -floor(Rational(-value)); }

Rational power(const Rational& base, unsigned exponent) {
  Rational result = 1;
  for (unsigned i = 0; i < exponent; ++i) result *= base;
  return result;
}

}  // namespace arete
