// SPDX-License-Identifier: MIT
// The tables of docs/smoothness.md are what the program computes, and agree with what is published.
#include <gtest/gtest.h>

#include <cmath>

#include "arete/analysis/hoelder.h"
#include "arete/analysis/limit_norm.h"
#include "arete/scheme/catalogue.h"
#include "support/markdown_table.h"
#include "support/oracle.h"

namespace arete {
namespace {

using test::markdown_table;

// A printed number and half a unit of its last digit.
struct Printed {
  double value = 0;
  double half_unit = 0;
};

Printed printed(const std::string& text) {
  std::size_t used = 0;
  Printed result{std::stod(text, &used), 0};
  const std::string number = text.substr(0, used);
  const auto dot = number.find('.');
  const int decimals = dot == std::string::npos ? 0 : static_cast<int>(number.size() - dot - 1);
  // An integer is meant exactly.
  result.half_unit = dot == std::string::npos ? 1e-9 : 0.5 * std::pow(10.0, -decimals) * 1.0001;
  return result;
}

TEST(PublishedValues, ExponentsOfTheTableAreProvedAndArePublished) {
  const auto rows = markdown_table("docs/smoothness.md", "Exponents");
  EXPECT_GE(rows.size(), 12u);
  for (const auto& row : rows) {
    SCOPED_TRACE(row.at(0));
    const Scheme scheme = parse_scheme(row.at(0));
    const HoelderBounds bounds = hoelder_bounds(scheme.mask());
    const Printed ours = printed(row.at(3));
    EXPECT_NEAR(bounds.lower, ours.value, ours.half_unit);
    EXPECT_NEAR(bounds.upper, ours.value, ours.half_unit);
    EXPECT_EQ(bounds.stability, Stability::stable);
    const Attained attained = row.at(4) == "yes"  ? Attained::yes
                              : row.at(4) == "no" ? Attained::no
                                                  : Attained::unknown;
    EXPECT_EQ(bounds.attained, attained);
    const Printed published = printed(row.at(1));
    EXPECT_NEAR(bounds.lower, published.value, 2.001 * published.half_unit);
    EXPECT_FALSE(row.at(2).empty()) << "who published it?";
  }
}

// The other tables print oracle values that tests/analysis/theorem_test.cpp meets.
void expect_oracle(const std::string& cell, const nlohmann::json& pair, int index) {
  const Printed shown = printed(cell);
  EXPECT_NEAR(pair.at(static_cast<std::size_t>(index)).get<double>(), shown.value, shown.half_unit)
      << cell;
}

TEST(PublishedValues, IntervalsOfTheTernaryTheoremAreThoseOfTheOracle) {
  const auto rows = markdown_table("docs/smoothness.md", "Theorem 3.1");
  ASSERT_EQ(rows.size(), 3u);
  const auto exact = test::ternary_and_reverse_records("t.theorem_3_1");
  const auto sharp = test::ternary_and_reverse_records("t.sharp_interval");
  for (std::size_t n = 0; n < 3; ++n) {
    for (const auto& record : exact)
      if (record.at("input").at("continuity") == n) {
        const auto& expect = record.at("expect");
        expect_oracle(rows[n].at(2), {expect.at("lower"), expect.at("upper")}, 0);
        expect_oracle(rows[n].at(3), {expect.at("lower"), expect.at("upper")}, 1);
      }
    for (const auto& record : sharp)
      if (record.at("input").at("continuity") == n) {
        const auto& expect = record.at("expect");
        expect_oracle(rows[n].at(4), {expect.at("lower"), expect.at("upper")}, 0);
        expect_oracle(rows[n].at(5), {expect.at("lower"), expect.at("upper")}, 1);
      }
  }
}

TEST(PublishedValues, WidthsByPowerAreThoseOfTheOracle) {
  const auto rows = markdown_table("docs/smoothness.md", "Larger powers");
  const auto records = test::ternary_and_reverse_records("t.power_L_interval");
  ASSERT_EQ(rows.size(), records.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    SCOPED_TRACE("L = " + rows[i].at(0));
    const auto& record = records[i];
    ASSERT_EQ(std::stoi(rows[i].at(0)), record.at("input").at("power").get<int>());
    for (std::size_t order = 0; order < 3; ++order) {
      const auto& expect = record.at("expect").at("C" + std::to_string(order));
      for (int end = 0; end < 2; ++end) {
        const std::string& cell = rows[i].at(1 + 2 * order + static_cast<std::size_t>(end));
        if (expect.is_null())
          EXPECT_EQ(cell, "none");
        else
          expect_oracle(cell, expect, end);
      }
    }
  }
}

TEST(PublishedValues, OvershootsOfTheTableAreProved) {
  const auto rows = markdown_table("docs/smoothness.md", "Overshoot");
  EXPECT_GE(rows.size(), 6u);
  for (const auto& row : rows) {
    SCOPED_TRACE(row.at(0));
    const auto norm = limit_norm(parse_scheme(row.at(0)).mask());
    ASSERT_TRUE(norm.has_value());
    const Printed share = printed(row.at(1));  // per cent
    EXPECT_NEAR(100 * to_double(norm->overshoot()), share.value, 2 * share.half_unit);
  }
}

}  // namespace
}  // namespace arete
