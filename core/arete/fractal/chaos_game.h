// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "arete/fractal/ifs.h"

namespace arete {

/// The chaos game: a point wanders, each step through one of the maps chosen at random with equal
/// chance, b <- b A_w; after the warm-up it fills the attractor. Endless, in constant memory.
///
/// Reproducible: the same seed gives the same points on every machine (mt19937_64, whose sequence
/// the C++ standard fixes; no standard distribution, whose sequence it does not).
///
/// The points start from the first control point; after k steps they are within the bound of
/// contraction.h of the attractor. The warm-up of 64 steps leaves nothing of the start when one
/// step halves it.
class ChaosGame {
 public:
  static constexpr int warm_up = 64;

  /// The arcs of one curve, all with the same maps; each step also draws the arc that is shown.
  /// \throws InvalidField without arcs, and as Ifs.
  ChaosGame(const MatrixSet<double>& set, const std::vector<Matrix<double>>& arcs,
            std::uint64_t seed);

  /// The next point; the reference holds until the next call.
  [[nodiscard]] const std::vector<double>& next();

 private:
  void step();
  [[nodiscard]] std::size_t draw(std::size_t count);

  std::vector<Ifs<double>> arcs_;
  std::mt19937_64 random_;
  std::vector<double> row_;
  std::vector<double> moved_;
  std::vector<double> point_;
};

}  // namespace arete
