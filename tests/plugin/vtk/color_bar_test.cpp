// SPDX-License-Identifier: MIT
#include "arete/vtk/internal/color_bar.h"
#include "arete/vtk/internal/ticks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "arete/vtk/internal/ticks.h"

namespace arete::vtk {
namespace {

TEST(ticks, are_round_evenly_spaced_within_and_neither_few_nor_many) {
  for (const double low : {-8000.0, -0.37, 0.0, 236.0, 1e-7, 123456.7}) {
    for (const double length : {1e-6, 0.02, 1.0, 9.99, 840.0, 12345.0}) {
      const double high = low + length;
      const auto values = ticks(low, high, 6);
      ASSERT_GE(values.size(), 2u) << low << " to " << high;
      ASSERT_LE(values.size(), 7u);
      EXPECT_GE(values.front(), low - 1e-6 * length);
      EXPECT_LE(values.back(), high + 1e-6 * length);
      const double step = values[1] - values[0];
      EXPECT_LT(values.front() - step, low) << "none is left out";
      EXPECT_GT(values.back() + step, high);
      const double mantissa = step / std::pow(10, std::floor(std::log10(step * 1.0001)));
      EXPECT_LT(std::min({std::abs(mantissa - 1), std::abs(mantissa - 2), std::abs(mantissa - 5)}),
                1e-3)
          << step;
      for (std::size_t k = 1; k < values.size(); ++k) {
        EXPECT_NEAR(values[k] - values[k - 1], step, 1e-3 * step);
      }
    }
  }
}

TEST(color_bar, longer_labels_ask_for_a_wider_strip) {
  const auto width = [](double low, double high) {
    return color_bar_width({low, high, "m", {}, 2}, 1000);
  };
  EXPECT_GT(width(10000, 20000), width(0, 10));
  EXPECT_GT(width(-900, -100), width(100, 900));
  EXPECT_GT(width(5, 5), 20) << "a bar of one height has a label too";
}

}  // namespace
}  // namespace arete::vtk
