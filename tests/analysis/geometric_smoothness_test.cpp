// SPDX-License-Identifier: MIT
// Tangents of corner cut curves, measured: docs/geometric-smoothness.md.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "arete/analysis/corner_cutting_facts.h"
#include "support/markdown_table.h"

namespace arete {
namespace {

using Polygon = std::vector<std::array<double, 2>>;

Polygon cut(const Polygon& c, double u, double v) {
  Polygon fine;
  for (std::size_t j = 0; j < c.size(); ++j) {
    const auto& a = c[j];
    const auto& b = c[(j + 1) % c.size()];
    fine.push_back({(1 - u) * a[0] + u * b[0], (1 - u) * a[1] + u * b[1]});
    fine.push_back({v * a[0] + (1 - v) * b[0], v * a[1] + (1 - v) * b[1]});
  }
  return fine;
}

double largest_turn(const Polygon& c) {
  const auto edge = [&c](std::size_t j) {
    const auto& a = c[j % c.size()];
    const auto& b = c[(j + 1) % c.size()];
    return std::array{b[0] - a[0], b[1] - a[1]};
  };
  double largest = 0;
  for (std::size_t j = 0; j < c.size(); ++j) {
    const auto d = edge(j);
    const auto e = edge(j + 1);
    largest = std::max(largest,
                       std::abs(std::atan2(d[0] * e[1] - d[1] * e[0], d[0] * e[0] + d[1] * e[1])));
  }
  return largest;
}

double turn_after(double u, double v, int steps) {
  Polygon polygon = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (int k = 0; k < steps; ++k) polygon = cut(polygon, u, v);
  return largest_turn(polygon);
}

TEST(GeometricSmoothness, TurningAnglesOfTheTableAreTrue) {
  const auto rows = test::markdown_table("docs/geometric-smoothness.md", "Turning angles");
  ASSERT_EQ(rows.size(), 3u);
  const int steps[] = {1, 2, 4, 8, 16};
  for (const auto& row : rows) {
    const double u = to_double(parse_rational(row.at(0)));
    for (std::size_t i = 0; i < 5; ++i)
      EXPECT_NEAR(turn_after(u, u, steps[i]), std::stod(row.at(i + 1)), 5.1e-5)
          << row.at(0) << " after " << steps[i];
  }
  for (int k = 1; k <= 14; ++k)
    EXPECT_NEAR(turn_after(1.0 / 3, 1.0 / 3, k), std::atan(1.0 / k), 1e-9) << k;
}

// The tangent is continuous exactly where the facts say so: turns tend to 0 inside the region, and
// stay outside it.
TEST(GeometricSmoothness, IsWhereTheFactsSay) {
  for (const auto& [u, v] : {std::pair{"1/4", "1/4"},
                             {"1/5", "3/10"},
                             {"1/10", "2/5"},
                             {"1/5", "1/5"},
                             {"3/10", "3/10"},
                             {"2/5", "2/5"},
                             {"1/5", "1/2"},
                             {"9/20", "1/10"},
                             {"9/20", "1/20"}}) {
    const Rational a = parse_rational(u), b = parse_rational(v);
    const double turn = turn_after(to_double(a), to_double(b), 16);
    const double before = turn_after(to_double(a), to_double(b), 12);
    if (corner_cutting_facts(a, b).smooth_tangent)
      EXPECT_LT(turn, 0.8 * before) << u << " " << v;
    else
      EXPECT_GT(turn, 0.97 * before) << u << " " << v;
  }
}

}  // namespace
}  // namespace arete
