// SPDX-License-Identifier: MIT
#include "arete/refine/noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace arete {
namespace {

// Known answers of the generator's authors (kat_vectors of Random123).
TEST(philox, known_answers) {
  using Counter = Philox::Counter;
  EXPECT_EQ(Philox::bits({0, 0, 0, 0}, {0, 0}),
            (Counter{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  constexpr std::uint32_t ones = 0xffffffff;
  EXPECT_EQ(Philox::bits({ones, ones, ones, ones}, {ones, ones}),
            (Counter{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(
      Philox::bits({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
      (Counter{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(noise, a_run_of_columns_equals_its_single_numbers) {
  for (const NoiseRow row : {NoiseRow{7, 1, 0}, NoiseRow{7, 3, -5}, NoiseRow{~0ULL, 2, 1LL << 39}})
    for (Index first : {Index{-7}, Index{-2}, Index{0}, Index{1}, (Index{1} << 32) - 3})
      for (Index count : {1, 2, 31, 32, 33, 100}) {
        std::vector<std::int32_t> run(static_cast<std::size_t>(count));
        row.fill({first, first + count - 1}, run.data());
        for (Index i = 0; i < count; ++i)
          ASSERT_EQ(run[static_cast<std::size_t>(i)], row.at(first + i)) << first << " + " << i;
      }
}

TEST(noise, has_mean_0_and_deviation_1_and_no_neighbour_knows_another) {
  constexpr Index side = 512;
  const auto plane = [](std::uint64_t seed, int level) {
    std::vector<double> values(side * side);
    std::vector<std::int32_t> row(side);
    for (Index r = 0; r < side; ++r) {
      NoiseRow{seed, level, r - 100}.fill({-200, side - 201}, row.data());
      for (Index c = 0; c < side; ++c)
        values[static_cast<std::size_t>(r * side + c)] =
            noise_unit * row[static_cast<std::size_t>(c)];
    }
    return values;
  };
  const auto correlation = [](const std::vector<double>& a, const std::vector<double>& b,
                              Index by) {
    double sum = 0;
    const auto shift = static_cast<std::size_t>(by);
    for (std::size_t i = 0; i + shift < a.size(); ++i) sum += a[i] * b[i + shift];
    return sum / static_cast<double>(a.size() - shift);
  };
  const std::vector<double> one = plane(5, 1);
  double mean = 0;
  for (double v : one) {
    mean += v / (side * side);
    ASSERT_LE(std::abs(v), 2 * std::sqrt(3.0));
  }
  // Five deviations of the mean of 2^18 numbers are 0.01.
  EXPECT_NEAR(mean, 0, 0.01);
  EXPECT_NEAR(correlation(one, one, 0), 1, 0.012);
  for (Index by : {Index{1}, Index{2}, side, side + 1})
    EXPECT_NEAR(correlation(one, one, by), 0, 0.01) << by;
  EXPECT_NEAR(correlation(one, plane(6, 1), 0), 0, 0.01) << "another seed";
  EXPECT_NEAR(correlation(one, plane(5, 2), 0), 0, 0.01) << "another level";
}

}  // namespace
}  // namespace arete
