// SPDX-License-Identifier: MIT
#include "arete/algebra/rational.h"

#include <gtest/gtest.h>

#include <cmath>

#include "arete/algebra/simplest_rational.h"

namespace arete {
namespace {

TEST(rational, decimals_are_taken_exactly) {
  EXPECT_EQ(parse_rational("0.1"), Rational(1, 10));
  EXPECT_EQ(parse_rational(" -7/32 "), Rational(-7, 32));
  EXPECT_EQ(parse_rational("-2.50E+1"), -25);
  EXPECT_EQ(parse_rational("1e-3"), Rational(1, 1000));
  EXPECT_EQ(parse_rational(".5"), Rational(1, 2));
  EXPECT_EQ(parse_rational("+3"), 3);
  EXPECT_EQ(parse_rational("007/08"), Rational(7, 8));
}

TEST(rational, text_round_trips) {
  for (const char* text : {"0", "-3/64", "12345678901234567890123/7", "5"})
    EXPECT_EQ(to_string(parse_rational(text)), text);
}

TEST(rational, anything_else_is_refused_with_the_text_named) {
  for (const char* text : {"", " ", "-", "a", "1/0", "1/", "/2", "1/-2", "1.2.3", "1e", "1e401",
                           "0x10", "nan", "inf", "1 2", "1,5", "--1", "1/2/3", "."}) {
    try {
      (void)parse_rational(text);
      ADD_FAILURE() << "accepted '" << text << "'";
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("'"), std::string::npos);
    }
  }
}

TEST(rational, floor_and_ceil_round_towards_the_infinities) {
  EXPECT_EQ(floor(Rational(7, 2)), 3);
  EXPECT_EQ(floor(Rational(-7, 2)), -4);
  EXPECT_EQ(ceil(Rational(-7, 2)), -3);
  EXPECT_EQ(ceil(Rational(4)), 4);
  EXPECT_EQ(floor(Rational(-4)), -4);
}

TEST(rational, conversion_to_double_rounds_to_nearest) {
  // |q - double(q)| must not exceed half the gap to either neighbour.
  for (int n = 1; n < 400; ++n) {
    const Rational exact(n * 7919, 3 * n + 1000003);
    const double rounded = to_double(exact);
    const auto distance = [&](double x) { return abs(Rational(exact - Rational(x))); };
    EXPECT_LE(distance(rounded), distance(std::nextafter(rounded, 1e9)));
    EXPECT_LE(distance(rounded), distance(std::nextafter(rounded, -1e9)));
  }
}

TEST(rational, the_simplest_fraction_that_rounds_to_a_double_is_what_was_meant) {
  for (int d = 1; d <= 200; ++d)
    for (int n = -2 * d; n <= 2 * d; ++n)
      EXPECT_EQ(simplest_rational(static_cast<double>(n) / d), Rational(n, d)) << n << "/" << d;
  for (double value : {0.1, 1e-300, 5e-324, 1.7976931348623157e308, 9007199254740993.0, 0x1p-1022,
                       3.141592653589793, -2.2250738585072014e-308})
    EXPECT_EQ(to_double(simplest_rational(value)), value);
}

}  // namespace
}  // namespace arete
