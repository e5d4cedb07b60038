// SPDX-License-Identifier: MIT
#include "arete/analysis/corner_cutting_facts.h"

#include "arete/algebra/characteristic_polynomial.h"
#include "arete/algebra/real_roots.h"

namespace arete {
namespace {

Matrix<Rational> from_rows(const std::array<std::array<Rational, 3>, 3>& rows) {
  Matrix<Rational> matrix(3, 3);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      matrix(i, j) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  return matrix;
}

bool has_roots(const Matrix<Rational>& matrix, const std::array<Rational, 3>& roots) {
  return characteristic_polynomial(matrix) == monic_polynomial({roots.begin(), roots.end()});
}

}  // namespace

Matrix<Rational> corner_cutting_left(const Rational& u, const Rational& v) {
  return from_rows({{{1 - u, u, 0}, {v, 1 - v, 0}, {0, 1 - u, u}}});
}

Matrix<Rational> corner_cutting_right(const Rational& u, const Rational& v) {
  return from_rows({{{v, 1 - v, 0}, {0, 1 - u, u}, {0, v, 1 - v}}});
}

CornerCuttingFacts corner_cutting_facts(const Rational& u, const Rational& v) {
  CornerCuttingFacts facts;
  const Rational middle = 1 - u - v;
  facts.left_spectrum = {Rational(1), middle, u};
  facts.right_spectrum = {Rational(1), middle, v};
  const bool both = u > 0 && v > 0;
  facts.degenerate = middle == 0 && both;
  facts.converges = (u >= 0 && v >= 0 && u + v > 0 && u + v < 1) || facts.degenerate;
  facts.smooth_parameter = both && 2 * (u + v) == 1;
  facts.smooth_tangent = both && 2 * u + v <= 1 && u + 2 * v <= 1;
  return facts;
}

std::vector<TheoremResult> corner_cutting_results(const Rational& u, const Rational& v) {
  const CornerCuttingFacts facts = corner_cutting_facts(u, v);
  TheoremResult convergence;
  convergence.name = "convergence of corner cutting (Kotarski, Gdawiec)";
  convergence.statement = "u, v >= 0 and 0 < u+v < 1";
  convergence.holds = facts.converges && !facts.degenerate;
  convergence.values = {u + v};
  convergence.nonnegative = {u, v};

  TheoremResult spectrum;
  spectrum.name = "spectra of L and R (Kotarski, Gdawiec)";
  spectrum.statement = "L: {1, 1-u-v, u}, R: {1, 1-u-v, v}; the spectrum tells the smoothness";
  spectrum.claims = -1;
  spectrum.holds = has_roots(corner_cutting_left(u, v), facts.left_spectrum) &&
                   has_roots(corner_cutting_right(u, v), facts.right_spectrum);
  spectrum.sound = false;
  spectrum.remark =
      "the spectra are right, but the smoothness is told by the joint spectral radius of the "
      "difference matrices, not by single spectra";
  if (facts.smooth_tangent && !facts.smooth_parameter)
    spectrum.remark +=
        "; as a curve the limit has a continuous tangent although its dyadic parametrisation is "
        "only C^0";
  return {convergence, spectrum};
}

}  // namespace arete
