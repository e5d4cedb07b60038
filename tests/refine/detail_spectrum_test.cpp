// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <map>
#include <unsupported/Eigen/FFT>

#include "arete/metrics/spectrum.h"
#include "arete/refine/refiner.h"
#include "arete/scheme/catalogue.h"

namespace arete {
namespace {

// Power of a closed square of n x n samples by frequency (kx, ky), 0 <= k < n.
Grid<double> power_spectrum(const Grid<double>& z) {
  const Index n = z.rows();
  Eigen::FFT<double> transform;
  std::vector<std::vector<std::complex<double>>> rows;
  for (Index r = 0; r < n; ++r) {
    const std::vector<double> line(z.row(r), z.row(r) + n);
    rows.emplace_back();
    transform.fwd(rows.back(), line);
    rows.back().resize(static_cast<std::size_t>(n));
  }
  Grid<double> power({n, n});
  // A real line's spectrum is its own mirror image: half of the columns are enough.
  for (Index c = 0; c <= n / 2; ++c) {
    std::vector<std::complex<double>> column, frequencies;
    for (Index r = 0; r < n; ++r)
      column.push_back(rows[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)]);
    transform.fwd(frequencies, column);
    for (Index r = 0; r < n; ++r) power(r, c) = std::norm(frequencies[static_cast<std::size_t>(r)]);
  }
  return power;
}

// The exponent of a power law through the mean power of rings, each of them `width` times as far
// out as the one before, for frequencies low <= k < high.
double radial_slope(const Grid<double>& power, double low, double high, double width) {
  const Index n = power.rows();
  struct Ring {
    double log_k = 0, power = 0;
    int count = 0;
  };
  std::map<int, Ring> rings;
  for (Index r = 0; r < n; ++r)
    for (Index c = 0; c <= n / 2; ++c) {
      const double k = std::hypot(std::min(r, n - r), c);
      if (k < low || k >= high) continue;
      Ring& ring = rings[static_cast<int>(std::floor(std::log(k / low) / std::log(width)))];
      ring.log_k += std::log(k);
      ring.power += power(r, c);
      ++ring.count;
    }
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  const auto m = static_cast<double>(rings.size());
  for (const auto& [number, ring] : rings) {
    const double x = ring.log_k / ring.count;
    const double y = std::log(ring.power / ring.count);
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  return (m * sxy - sx * sy) / (m * sxx - sx * sx);
}

// Rows alternate by 1: local relief 1 everywhere, and nothing between the input's Nyquist frequency
// and that of the result but the detail (and what the scheme leaks of the input, taken off).
Grid<double> detail_alone(const Scheme& scheme, double roughness, int levels, std::uint64_t seed,
                          bool keep) {
  constexpr Index side = 16;
  Grid<double> input({side, side});
  for (Index r = 0; r < side; ++r)
    for (Index c = 0; c < side; ++c) input(r, c) = static_cast<double>(r % 2);
  RefineOptions options;
  options.levels = levels;
  options.boundaries = {Boundary::periodic, Boundary::periodic};
  const Grid<double> smooth = refine(input, scheme, options);
  options.detail = Detail{roughness, 0.5, seed, keep};
  Grid<double> rough = refine(input, scheme, options);
  for (std::size_t i = 0; i < rough.samples().size(); ++i)
    rough.samples()[i] -= smooth.samples()[i];
  return rough;
}

// From the second level's band on: into the first one's reaches what the schemes leave of the input
// above its Nyquist frequency (8 here), and that was taken off.
double slope_of(const char* name, double roughness, int levels, bool keep, double width) {
  const Scheme scheme = parse_scheme(name);
  const Grid<double> z = detail_alone(scheme, roughness, levels, 17, keep);
  return radial_slope(power_spectrum(z), 8.0 * scheme.mask().arity(),
                      static_cast<double>(z.rows()) / 2, width);
}

// One ring a level.
TEST(detail, the_spectrum_falls_from_level_to_level_as_the_roughness_asks) {
  struct Case {
    const char* scheme;
    int arity;
    int levels;
  };
  for (const Case& c : {Case{"dubuc-deslauriers:points=6", 2, 5}, Case{"de-rham", 2, 5},
                        Case{"b-spline:degree=5", 2, 5}, Case{"ternary-four-point", 3, 3}})
    for (double roughness : {0.3, 0.7})
      for (bool keep : {true, false})
        EXPECT_NEAR(slope_of(c.scheme, roughness, c.levels, keep, c.arity), -(2 * roughness + 2),
                    0.1)
            << c.scheme << " roughness " << roughness;
}

// Four rings an octave: the spectrum is also near the power law within the octaves.
TEST(detail, the_spectrum_falls_as_the_roughness_asks) {
  for (const char* name :
       {"four-point", "b-spline:degree=1", "b-spline:degree=3", "chaikin", "gentle"})
    for (double roughness : {0.2, 0.5, 0.8})
      EXPECT_NEAR(slope_of(name, roughness, 5, true, std::pow(2, 0.25)), -(2 * roughness + 2), 0.1)
          << name << " roughness " << roughness;
}

// What `arete refine` reports: the slope of profiles, which is one less steep than the radial one.
TEST(detail, profiles_fall_as_the_roughness_asks) {
  for (const char* name : {"four-point", "dubuc-deslauriers:points=6", "b-spline:degree=3"})
    for (const double roughness : {0.3, 0.5, 0.7, 0.9}) {
      constexpr int seeds = 4;
      double mean = 0;
      for (int seed = 1; seed <= seeds; ++seed) {
        const Grid<double> z =
            detail_alone(parse_scheme(name), roughness, 5, static_cast<std::uint64_t>(seed), true);
        const double slope = refined_slope(z.view(), 32).value().slope;
        EXPECT_NEAR(slope, -(2 * roughness + 1), 0.2) << name << ", " << roughness << ", " << seed;
        mean += slope / seeds;
      }
      EXPECT_NEAR(mean, -(2 * roughness + 1), 0.1) << name << " roughness " << roughness;
    }
}

// Why the last octave counts for nothing: profiles are much flatter there than the roughness asks.
TEST(detail, profiles_of_the_last_octave_tell_nothing) {
  for (const double roughness : {0.3, 0.6, 0.9}) {
    const Grid<double> z = detail_alone(parse_scheme("four-point"), roughness, 5, 17, true);
    const auto last = spectral_slope(profile_spectrum(z.view()), 0.25, 0.5);
    EXPECT_GT(last.value().slope, -(2 * roughness + 1) + 0.5);
  }
}

}  // namespace
}  // namespace arete
