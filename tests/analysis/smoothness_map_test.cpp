// SPDX-License-Identifier: MIT
#include "arete/analysis/smoothness_map.h"

#include <gtest/gtest.h>

#include <sstream>

#include "arete/scheme/catalogue.h"

namespace arete {
namespace {

std::optional<Mask> line_member(const Rational& lambda, const Rational& omega) {
  if (lambda > Rational(1) / 2) return std::nullopt;
  return make_scheme("four-parameter", {{"lambda", {lambda}}, {"mu", {lambda}}, {"omega", {omega}}})
      .mask();
}

// The map never says more than the full analysis, and agrees where it decides.
TEST(SmoothnessMap, AgreesWithTheFullAnalysis) {
  std::vector<Rational> xs;
  std::vector<Rational> ys;
  for (int i = 0; i < 9; ++i) xs.push_back(Rational(i) / 12);
  for (int i = 0; i < 7; ++i) ys.push_back(Rational(i - 3) / 10);
  const auto cells = smoothness_map(xs, ys, line_member);
  ASSERT_EQ(cells.size(), xs.size() * ys.size());
  int decided = 0;
  for (std::size_t at = 0; at < cells.size(); ++at) {
    const auto mask = line_member(xs[at % xs.size()], ys[at / xs.size()]);
    ASSERT_EQ(cells[at].valid, mask.has_value());
    if (!mask) continue;
    const Smoothness full = analyze_smoothness(*mask);
    EXPECT_LE(cells[at].certified, full.certified);
    EXPECT_LE(cells[at].hoelder_lower, full.hoelder.upper);
    if (cells[at].refuted_next) {
      EXPECT_EQ(cells[at].certified, full.certified);
      ++decided;
    }
  }
  EXPECT_GT(decided, 20);
}

// The map of the specification for nu = 1/2, lambda = mu: columns 16 lambda = -3..11, rows
// 16 omega = 8..-8. The one order it leaves open (omega = -7/16, lambda = 7/16) is C^1.
TEST(SmoothnessMap, MeetsTheMapOfTheSpecification) {
  const char* const rows[] = {"0 0 0 - - - - -u - - - - - - -",  "0 0 0 0 0 - - -u - - - - - - -",
                              "0 0 0 0 0 0 0 -u - - - - - - -",  "0 0 0 0 0 0 0 0u 0 - - - - - -",
                              "0 0 0 0 0 0 0 0u 0 0 0 - - - -",  "1 1 1 1 0 0 0 0u 0 0 0 0 0 - -u",
                              "0 1 1 1 1 1 1 0u 0 0 0 0 0 0u -", "0 0 1 1 1 1 1 1u 1 0 0 0 0u 0 0",
                              "0 0 0 0 1 2 1 1u 1 1 1 0u 0 0 0", "0 0 0 0 1 1 1 3u 1 1 1u 1 0 0 0",
                              "- 0 0 0 0 1 1 1u 1 2u 1 1 1 0 0", "- - 0 0 0 0 1 1u 1u 1u 1 1 1 0 0",
                              "- - 0 0 0 0 1 1u 1 1 1 1u 1 1 0", "- - 0 0 0 0 1u 1u 1 1 1 1 1 1u 1",
                              "- - - 0 0 0u 0 0u 1 1 1 1 1 1 1", "- - - 0 0u 0 0 0u 0 0 1 1 1 1 1",
                              "- - - -u 0 0 0 0u 0 0 0 0u 0 0 0"};
  std::vector<Rational> lambdas;
  std::vector<Rational> omegas;
  for (int i = -3; i <= 11; ++i) lambdas.push_back(Rational(i) / 16);
  for (int i = 8; i >= -8; --i) omegas.push_back(Rational(i) / 16);
  const auto cells =
      smoothness_map(lambdas, omegas, [](const Rational& lambda, const Rational& omega) {
        return std::optional(
            make_scheme("four-parameter",
                        {{"lambda", {lambda}}, {"mu", {lambda}}, {"omega", {omega}}})
                .mask());
      });
  for (std::size_t row = 0; row < omegas.size(); ++row) {
    std::istringstream texts(rows[row]);
    for (std::size_t column = 0; column < lambdas.size(); ++column) {
      std::string text;
      texts >> text;
      const MapCell& cell = cells[row * lambdas.size() + column];
      SCOPED_TRACE("lambda " + to_string(lambdas[column]) + " omega " + to_string(omegas[row]));
      EXPECT_EQ(!cell.stable, text.ends_with('u'));
      EXPECT_EQ(cell.certified, text[0] == '-' ? -1 : text[0] - '0');
      if (text[0] == '-' || !text.ends_with('u')) {
        EXPECT_TRUE(cell.refuted_next);
      }
    }
  }
}

TEST(SmoothnessMap, CanBeStopped) {
  const std::vector<Rational> xs(50, Rational(1) / 8);
  const auto cells =
      smoothness_map(xs, xs, line_member, map_options(), [](std::size_t) { return false; });
  std::size_t invalid = 0;
  for (const MapCell& cell : cells) invalid += cell.valid ? 0 : 1;
  EXPECT_GT(invalid, 0U);
}

}  // namespace
}  // namespace arete
