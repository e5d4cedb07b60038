// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "arete/field/grid.h"
#include "support/oracle.h"

namespace arete::test {

/// A table of exact numbers; a list of numbers becomes one column.
inline Grid<Rational> exact_grid(const nlohmann::json& rows) {
  std::vector<std::vector<Rational>> table;
  for (const auto& row : rows)
    table.push_back(row.is_array() ? exact_list(row) : std::vector<Rational>{exact(row)});
  Grid<Rational> grid({static_cast<Index>(table.size()),
                       table.empty() ? 1 : static_cast<Index>(table.front().size())});
  for (Index r = 0; r < grid.rows(); ++r)
    for (Index c = 0; c < grid.cols(); ++c)
      grid(r, c) = table[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)];
  return grid;
}

inline Grid<double> to_double(const Grid<Rational>& exact) {
  Grid<double> grid(exact.extent());
  for (std::size_t i = 0; i < exact.samples().size(); ++i)
    grid.samples()[i] = arete::to_double(exact.samples()[i]);
  return grid;
}

/// Small integers, as exact as the ring.
template <class R>
Grid<R> random_integers(Extent extent, unsigned seed) {
  std::mt19937 random(seed);
  Grid<R> grid(extent);
  for (R& value : grid.samples()) value = R(static_cast<int>(random() % 201) - 100);
  return grid;
}

inline void expect_exact(const Grid<Rational>& actual, const Grid<Rational>& expected,
                         const std::string& what) {
  ASSERT_EQ(actual.extent(), expected.extent()) << what;
  for (std::size_t i = 0; i < expected.samples().size(); ++i)
    EXPECT_EQ(actual.samples()[i], expected.samples()[i]) << what << ", number " << i;
}

/// Largest difference, relative to the largest expected number or 1.
inline double relative_difference(const Grid<double>& actual, const Grid<double>& expected) {
  EXPECT_EQ(actual.extent(), expected.extent());
  if (!(actual.extent() == expected.extent())) return 1;
  double scale = 1;
  double largest = 0;
  for (std::size_t i = 0; i < expected.samples().size(); ++i) {
    scale = std::max(scale, std::abs(expected.samples()[i]));
    const double difference = std::abs(actual.samples()[i] - expected.samples()[i]);
    largest = std::max(largest, std::isnan(difference) ? 1e300 : difference);
  }
  return largest / scale;
}

inline void expect_near(const Grid<double>& actual, const Grid<Rational>& expected,
                        const std::string& what) {
  EXPECT_LE(relative_difference(actual, to_double(expected)), 1e-12) << what;
}

}  // namespace arete::test
