// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "arete/field/grid.h"

namespace arete {

/// Mean power of the profiles along both axes by wavenumber, in cycles per sample: how rough a
/// surface is at which scale. A profile of a surface with Hurst exponent H (heights that differ by
/// ~ d^H over a distance d) has a power that falls as k^-(2H + 1).
struct ProfileSpectrum {
  std::vector<double> wavenumber;  ///< ascending, in (0, 1/2]
  std::vector<double> power;       ///< mean over the profiles, unit of the heights squared
  Index profiles = 0;
};

/// The spectrum of rows and columns: of each the longest run of samples without a gap, cut to one
/// common power of two, its straight line taken away, under a Hann window. At most `most_profiles`
/// profiles an axis, evenly spread. Empty if no run is `shortest` samples long.
[[nodiscard]] ProfileSpectrum profile_spectrum(GridView<const double> heights,
                                               Index most_profiles = 512);
inline constexpr Index shortest_profile = 32;

/// The mean of some neighbouring wavenumbers.
struct SpectrumBin {
  double wavenumber = 0;  ///< geometric mean
  double power = 0;       ///< arithmetic mean
};

/// Means over quarter octaves from `lowest` on, up to `highest` (cycles per sample); quarters that
/// hold no wavenumber are left out.
[[nodiscard]] std::vector<SpectrumBin> spectrum_bins(const ProfileSpectrum& spectrum, double lowest,
                                                     double highest);

/// A straight line through log power over log wavenumber.
struct SpectralSlope {
  double slope = 0;   ///< of the power; about -(2H + 1)
  double hurst = 0;   ///< (-slope - 1)/2
  double lowest = 0;  ///< the wavenumbers it was fitted to
  double highest = 0;
};

/// The slope between two wavenumbers (cycles per sample), by least squares over spectrum_bins(), so
/// that the many high wavenumbers do not outweigh the few low ones. Nothing
/// where fewer than three such means have any power.
[[nodiscard]] std::optional<SpectralSlope> spectral_slope(const ProfileSpectrum& spectrum,
                                                          double lowest, double highest);

/// The slope over all that a grid of this size can tell: from the fourth wavenumber up to 1/4
/// cycle per sample, beyond which interpolation and noise of the samples rule.
[[nodiscard]] std::optional<SpectralSlope> spectral_slope(GridView<const double> heights);

/// The slope of the octaves that a refinement made, `factor` samples for one along an axis: from
/// the second of them on (into the first reaches what the scheme leaves of the input) up to 1/4
/// cycle per sample. The last octave is left out: profiles of a surface with any power law up to
/// the corners of its square of wavenumbers are nearly flat there. Nothing for a factor below 8,
/// which makes no octaves but those two. For detail of roughness H -(2H + 1), to 0.1 for factors
/// from 16 on, to 0.15 for 8.
[[nodiscard]] std::optional<SpectralSlope> refined_slope(GridView<const double> heights,
                                                         double factor);

}  // namespace arete
