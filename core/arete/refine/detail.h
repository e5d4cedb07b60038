// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace arete {

/// Surface detail: random displacement added level by level, as in midpoint displacement
/// (Fournier, Fussell, Carpenter, "Computer rendering of stochastic models", CACM 25, 1982; Saupe
/// in "The Science of Fractal Images", 1988), with the refinement scheme in the place of their
/// averages.
///
/// After level l = 1, 2, ... each new sample (all that do not stand on a sample of the level
/// before; every sample of a dual scheme) is moved by
///
///     relief m^{-H (l-1)} R(x) xi,
///
/// - m the arity (m^{-l} is the spacing of level l; with two arities their geometric mean),
/// - R(x) the local relief of the input: the range (largest minus smallest height) of the valid
///   samples among the 3 x 3 around an input sample, interpolated bilinearly between them: plains
///   stay plain,
/// - xi independent numbers of mean 0 and deviation 1, bell-shaped (the sum of four uniform ones),
///   none beyond 2 sqrt(3).
///
/// xi depends on seed, level, row and column alone, so every cut into bands and any number of
/// threads give the same bits. Along a periodic axis it closes. No later level smooths the last
/// ones, so the last two displacements have factors of their own (see ClosingGain): with them the
/// radial power spectrum of the result falls as k^{-(2H+2)} up to its Nyquist frequency. (A scheme
/// whose own limit is rougher than H, such as craggy, shows its own spectrum.)
struct Detail {
  /// H, the Hurst exponent, 0 (raw) to 2 (smooth); terrain is mostly 0.5 to 0.9. Amplitude falls by
  /// m^-H a level, the radial power spectrum as k^{-(2H+2)}, that of a profile as k^{-(2H+1)}.
  double roughness = 0.5;
  /// Deviation of the first level's displacement as a share of the local relief, 0 (nothing at all)
  /// or more. About 0.26, 0.17, 0.09 for H = 0.2, 0.5, 0.8 continue a fractional Brownian surface
  /// without a step in its spectrum.
  double relief = 0.15;
  /// Another seed, another surface of the same character.
  std::uint64_t seed = 0;
  /// Samples of the level before are not displaced, so an interpolatory scheme passes through the
  /// input. false: every sample of every level is displaced (successive random additions).
  bool keep_samples = true;
};

}  // namespace arete
