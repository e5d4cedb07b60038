// SPDX-License-Identifier: MIT
#include "arete/metrics/spectrum.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>

namespace arete {
namespace {

// The longest run of finite numbers.
std::vector<double> longest_run(const std::vector<double>& profile) {
  std::size_t best = 0;
  std::size_t best_end = 0;
  std::size_t length = 0;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    length = std::isfinite(profile[i]) ? length + 1 : 0;
    if (length > best) {
      best = length;
      best_end = i + 1;
    }
  }
  const auto end = profile.begin() + static_cast<std::ptrdiff_t>(best_end);
  return {end - static_cast<std::ptrdiff_t>(best), end};
}

// Takes the least squares line away, which would leak into all wavenumbers, and fades the ends.
void prepare(std::vector<double>& profile) {
  const auto n = static_cast<double>(profile.size());
  double mean = 0;
  double tilt = 0;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    mean += profile[i] / n;
    tilt += profile[i] * (static_cast<double>(i) - (n - 1) / 2);
  }
  tilt *= 12 / (n * (n * n - 1));
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const double t = static_cast<double>(i) - (n - 1) / 2;
    const double hann = 0.5 + 0.5 * std::cos(2 * std::numbers::pi * t / n);
    profile[i] = (profile[i] - mean - tilt * t) * hann;
  }
}

std::vector<std::vector<double>> profiles_of(GridView<const double> heights, Index most) {
  std::vector<std::vector<double>> profiles;
  const auto add = [&](Index count, Index length, const auto& at) {
    const Index taken = std::min(count, most);
    for (Index k = 0; k < taken; ++k) {
      const Index line = (2 * k + 1) * count / (2 * taken);
      std::vector<double> profile(static_cast<std::size_t>(length));
      for (Index i = 0; i < length; ++i) profile[static_cast<std::size_t>(i)] = at(line, i);
      profile = longest_run(profile);
      if (static_cast<Index>(profile.size()) >= shortest_profile)
        profiles.push_back(std::move(profile));
    }
  };
  add(heights.rows(), heights.cols(), [&](Index line, Index i) { return heights(line, i); });
  add(heights.cols(), heights.rows(), [&](Index line, Index i) { return heights(i, line); });
  return profiles;
}

// A length that most profiles have, as a power of two.
std::size_t common_length(const std::vector<std::vector<double>>& profiles) {
  std::vector<std::size_t> lengths;
  for (const auto& profile : profiles) lengths.push_back(std::bit_floor(profile.size()));
  const auto low = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 4);
  std::nth_element(lengths.begin(), low, lengths.end());
  return *low;
}

}  // namespace

ProfileSpectrum profile_spectrum(GridView<const double> heights, Index most_profiles) {
  std::vector<std::vector<double>> profiles = profiles_of(heights, most_profiles);
  ProfileSpectrum spectrum;
  if (profiles.empty()) return spectrum;
  const std::size_t length = common_length(profiles);
  std::vector<double> power(length / 2 + 1, 0.0);
  Eigen::FFT<double> fft;
  std::vector<std::complex<double>> waves;
  for (std::vector<double>& profile : profiles) {
    if (profile.size() < length) continue;
    // From its middle.
    const auto from = static_cast<std::ptrdiff_t>((profile.size() - length) / 2);
    std::vector<double> part(profile.begin() + from,
                             profile.begin() + from + static_cast<std::ptrdiff_t>(length));
    prepare(part);
    fft.fwd(waves, part);
    for (std::size_t k = 0; k < power.size(); ++k) power[k] += std::norm(waves[k]);
    ++spectrum.profiles;
  }
  const double scale = 1 / (static_cast<double>(spectrum.profiles) * static_cast<double>(length));
  for (std::size_t k = 1; k < power.size(); ++k) {
    spectrum.wavenumber.push_back(static_cast<double>(k) / static_cast<double>(length));
    spectrum.power.push_back(power[k] * scale);
  }
  return spectrum;
}

std::vector<SpectrumBin> spectrum_bins(const ProfileSpectrum& spectrum, double lowest,
                                       double highest) {
  constexpr double bins_per_octave = 4;
  std::vector<SpectrumBin> bins;
  std::vector<double> counts;
  for (std::size_t i = 0; i < spectrum.wavenumber.size(); ++i) {
    const double k = spectrum.wavenumber[i];
    if (k < lowest || k > highest) continue;
    const auto number =
        static_cast<std::size_t>(std::floor(bins_per_octave * std::log2(k / lowest) + 1e-9));
    if (number >= bins.size()) {
      bins.resize(number + 1);
      counts.resize(number + 1, 0.0);
    }
    bins[number].wavenumber += std::log(k);
    bins[number].power += spectrum.power[i];
    ++counts[number];
  }
  for (std::size_t i = 0; i < bins.size(); ++i)
    bins[i] = {std::exp(bins[i].wavenumber / counts[i]), bins[i].power / counts[i]};
  std::erase_if(bins, [](const SpectrumBin& bin) { return std::isnan(bin.power); });
  return bins;
}

std::optional<SpectralSlope> spectral_slope(const ProfileSpectrum& spectrum, double lowest,
                                            double highest) {
  SpectralSlope result;
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (const SpectrumBin& bin : spectrum_bins(spectrum, lowest, highest)) {
    if (!(bin.power > 0)) continue;
    const double x = std::log(bin.wavenumber);
    const double y = std::log(bin.power);
    if (n == 0) result.lowest = bin.wavenumber;
    result.highest = bin.wavenumber;
    ++n;
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  if (n < 3) return std::nullopt;
  result.slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
  result.hurst = (-result.slope - 1) / 2;
  return result;
}

std::optional<SpectralSlope> spectral_slope(GridView<const double> heights) {
  const ProfileSpectrum spectrum = profile_spectrum(heights);
  if (spectrum.wavenumber.empty()) return std::nullopt;
  return spectral_slope(spectrum, 4 * spectrum.wavenumber.front(), 0.25);
}

std::optional<SpectralSlope> refined_slope(GridView<const double> heights, double factor) {
  if (!(factor >= 8)) return std::nullopt;
  return spectral_slope(profile_spectrum(heights), 1 / factor, 0.25);
}

}  // namespace arete
