// SPDX-License-Identifier: MIT
#include "arete/metrics/spectrum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "support/fields.h"

namespace arete {
namespace {

// Rows and columns are sums of waves whose power falls as k^-(2H + 1), random phases: a field
// whose every profile has that spectrum by construction.
Grid<double> rough_field(Index side, double hurst, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> phase(0, 2 * M_PI);
  Grid<double> z({side, side});
  const auto n = static_cast<double>(side);
  for (Index k = 1; k < side / 2; ++k) {
    const double amplitude = std::pow(static_cast<double>(k), -(2 * hurst + 1) / 2);
    const double a = phase(random);
    const double b = phase(random);
    for (Index r = 0; r < side; ++r)
      for (Index c = 0; c < side; ++c)
        z(r, c) += amplitude * (std::cos(2 * M_PI * static_cast<double>(k * c) / n + a) +
                                std::cos(2 * M_PI * static_cast<double>(k * r) / n + b));
  }
  return z;
}

TEST(spectral_slope, is_that_of_the_waves_a_field_is_made_of) {
  for (const double hurst : {0.2, 0.5, 0.8, 1.2}) {
    double mean = 0;
    constexpr int fields = 16;
    for (unsigned seed = 0; seed < fields; ++seed) {
      const auto slope = spectral_slope(rough_field(128, hurst, seed).view());
      ASSERT_TRUE(slope);
      EXPECT_NEAR(slope->hurst, (-slope->slope - 1) / 2, 1e-12);
      mean += slope->slope / fields;
    }
    EXPECT_NEAR(mean, -(2 * hurst + 1), 0.1) << hurst;
  }
}

TEST(spectral_slope, of_white_noise_is_flat_and_of_a_walk_is_two) {
  std::mt19937 random(2);
  std::normal_distribution<double> step;
  Grid<double> noise({256, 256});
  for (double& z : noise.samples()) z = step(random);
  EXPECT_NEAR(spectral_slope(noise.view())->slope, 0, 0.05);
  // A sum of a walk along rows and one along columns: every profile is a walk.
  Grid<double> walk({256, 256});
  std::vector<double> along(256), down(256);
  for (std::size_t i = 1; i < 256; ++i) {
    along[i] = along[i - 1] + step(random);
    down[i] = down[i - 1] + step(random);
  }
  for (Index r = 0; r < 256; ++r)
    for (Index c = 0; c < 256; ++c)
      walk(r, c) = along[static_cast<std::size_t>(c)] + down[static_cast<std::size_t>(r)];
  // One walk each, so that the estimate scatters.
  EXPECT_NEAR(spectral_slope(walk.view())->slope, -2, 0.4);
}

TEST(profile_spectrum, peaks_at_the_wave_and_holds_its_power) {
  Grid<double> z({64, 128});
  for (Index r = 0; r < 64; ++r)
    for (Index c = 0; c < 128; ++c)
      z(r, c) = 1000 + 7 * static_cast<double>(c) +
                3 * std::cos(2 * M_PI * 0.125 * static_cast<double>(c + r));
  const ProfileSpectrum s = profile_spectrum(z.view());
  const auto peak = std::max_element(s.power.begin(), s.power.end()) - s.power.begin();
  EXPECT_EQ(s.wavenumber[static_cast<std::size_t>(peak)], 0.125);
  // The plane leaves nothing behind: all else is the window's skirt.
  for (std::size_t i = 0; i < s.power.size(); ++i)
    if (std::abs(s.wavenumber[i] - 0.125) > 0.06) {
      EXPECT_LT(s.power[i], 5e-3 * s.power[static_cast<std::size_t>(peak)]) << s.wavenumber[i];
    }
}

TEST(profile_spectrum, holes_cut_profiles_and_change_little) {
  const Grid<double> whole = rough_field(256, 0.6, 9);
  Grid<double> holed = whole;
  for (Index i = 0; i < 20; ++i)
    holed(13 * i % 256, 255 - 3 * i) = std::numeric_limits<double>::quiet_NaN();
  const auto a = spectral_slope(whole.view());
  const auto b = spectral_slope(holed.view());
  ASSERT_TRUE(a && b);
  EXPECT_NEAR(a->slope, b->slope, 0.05);
}

TEST(spectral_slope, small_and_empty_fields_have_none) {
  EXPECT_FALSE(spectral_slope(test::random_heights({16, 16}).view()));
  EXPECT_FALSE(spectral_slope(Grid<double>().view()));
  EXPECT_FALSE(
      spectral_slope(Grid<double>({64, 64}, std::numeric_limits<double>::quiet_NaN()).view()));
  EXPECT_FALSE(spectral_slope(Grid<double>({64, 64}, 5.0).view()));
}

}  // namespace
}  // namespace arete
