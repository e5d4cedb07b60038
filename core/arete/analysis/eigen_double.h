// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "arete/algebra/matrix.h"

namespace arete {

/// Eigenvalues in floating point. They propose (words, eigenvectors); nothing is ever claimed on
/// their word alone.

[[nodiscard]] double approximate_spectral_radius(const Matrix<double>& a);

/// The eigenvectors of all eigenvalues of the largest modulus (relative 1e-8); of a complex pair
/// the real and the imaginary part.
struct LeadingVectors {
  double radius = 0;
  std::vector<std::vector<double>> vectors;
};
[[nodiscard]] LeadingVectors leading_vectors(const Matrix<double>& a);

}  // namespace arete
