// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "arete/algebra/matrix.h"
#include "arete/algebra/rational.h"

namespace arete {

/// All eigenvalues of a square matrix, with their multiplicities, from the largest modulus down (of
/// equal ones the positive first), if all of them are rational; exact. Nothing otherwise: the
/// characteristic polynomial (algebra/characteristic_polynomial.h) is exact for every matrix.
///
/// Floating-point roots of the square-free part are only guesses; each is verified and divided out
/// exactly. Denominators above about 1e6 are not found.
///
/// Beware: the spectra of the single matrices do not tell how smooth the curve is. De Rham's curve
/// (u = v = 1/3) has the eigenvalues 1, 1/3, 1/3 but only the Hoelder exponent 0.89; that takes the
/// joint spectral radius (analysis/joint_spectral_radius.h).
[[nodiscard]] std::optional<std::vector<Rational>> rational_spectrum(const Matrix<Rational>& a);

}  // namespace arete
