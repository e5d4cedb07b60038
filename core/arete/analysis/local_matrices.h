// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "arete/algebra/matrix.h"
#include "arete/analysis/word.h"
#include "arete/scheme/mask.h"

namespace arete {

/// The m square matrices by which the operator (S_q p)_k = sum_j q_{k - m j} p_j takes a window of
/// n consecutive values to the m windows of n consecutive values below it. With q shifted to
/// c_0..c_d and n = max(1, ceil(d/(m-1))), digit i = 0..m-1 stands for
///
///     (D_i)_{rs} = c_{d - i + r - m s},   r, s = 0..n-1.
///
/// For m = 2 these are the pair A (digit 0), B (digit 1) of the literature. The joint spectral
/// radius JSR(q) = lim ||S_q^L||^{1/L} is that of this set, and ||S_q^L||_inf is the largest
/// infinity norm of its products of length L. For m = 2 and d = 0: A = (c_0), B = (0).
struct LocalMatrices {
  int arity = 2;
  int size = 1;
  std::vector<Matrix<Rational>> matrices;
};

/// q must not be zero; its lowest exponent does not matter.
[[nodiscard]] LocalMatrices local_matrices(int arity, const LaurentPolynomial<Rational>& q);

/// The product of the word, first digit applied first; the identity for the empty word.
[[nodiscard]] Matrix<Rational> word_product(const LocalMatrices& local, const Word& word);

/// Whether spectral_radius(word)^{1/length} >= bound >= 0, decided exactly. Then JSR >= bound.
[[nodiscard]] bool word_reaches(const LocalMatrices& local, const Word& word,
                                const Rational& bound);

/// A mask with all its smoothing factors divided out: a = (1 + ... + z^{m-1})^rules rest.
struct FactoredMask {
  int rules = 0;
  LaurentPolynomial<Rational> rest;
};
[[nodiscard]] FactoredMask factored(const Mask& mask);

}  // namespace arete
