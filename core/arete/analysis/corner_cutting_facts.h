// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "arete/analysis/theorem.h"

namespace arete {

/// Corner cutting f_{2j} = (1-u) c_j + u c_{j+1}, f_{2j+1} = v c_j + (1-v) c_{j+1} (Kotarski,
/// Gdawiec). The pair L, R takes three control points to the three of the left and of the right
/// half; its spectra are as printed, but "the spectrum tells the smoothness" is false: at
/// u = v = 1/3 every eigenvalue except 1 is 1/3, which alone would suggest log2 3 = 1.585, while
/// the exponent is 0.8907 (the joint spectral radius of the differences is golden ratio / 3).
struct CornerCuttingFacts {
  std::array<Rational, 3> left_spectrum;   ///< {1, 1-u-v, u}
  std::array<Rational, 3> right_spectrum;  ///< {1, 1-u-v, v}
  bool converges = false;                  ///< u, v >= 0 and 0 < u+v < 1, or u+v = 1 with u, v > 0
  bool degenerate = false;  ///< u+v = 1: the limit is the segment between two division points
  /// C^1 as a function of the dyadic parameter: u+v = 1/2 with u, v > 0.
  bool smooth_parameter = false;
  /// The limit *curve* of a polygon in general position has a continuous tangent: u, v > 0,
  /// 2u+v <= 1, u+2v <= 1. Weaker than the above: de Rham's curve u = v = 1/3 has a tangent
  /// everywhere, but its dyadic parametrisation is only C^0.
  bool smooth_tangent = false;
};

[[nodiscard]] CornerCuttingFacts corner_cutting_facts(const Rational& u, const Rational& v);

/// The matrices themselves, exact; their rows give the new points.
[[nodiscard]] Matrix<Rational> corner_cutting_left(const Rational& u, const Rational& v);
[[nodiscard]] Matrix<Rational> corner_cutting_right(const Rational& u, const Rational& v);

/// Convergence and the claim of the spectrum as results.
[[nodiscard]] std::vector<TheoremResult> corner_cutting_results(const Rational& u,
                                                                const Rational& v);

}  // namespace arete
