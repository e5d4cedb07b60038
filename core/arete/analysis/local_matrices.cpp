// SPDX-License-Identifier: MIT
#include "arete/analysis/local_matrices.h"

#include "arete/algebra/schur_cohn.h"

namespace arete {

LocalMatrices local_matrices(int arity, const LaurentPolynomial<Rational>& q) {
  const int degree = q.highest() - q.lowest();
  LocalMatrices local;
  local.arity = arity;
  local.size = std::max(1, (degree + arity - 2) / (arity - 1));
  for (int digit = 0; digit < arity; ++digit) {
    Matrix<Rational> matrix(local.size, local.size);
    for (int r = 0; r < local.size; ++r)
      for (int s = 0; s < local.size; ++s)
        matrix(r, s) = q[q.lowest() + degree - digit + r - arity * s];
    local.matrices.push_back(std::move(matrix));
  }
  return local;
}

Matrix<Rational> word_product(const LocalMatrices& local, const Word& word) {
  auto product = Matrix<Rational>::identity(local.size);
  for (const int digit : word) product = local.matrices[static_cast<std::size_t>(digit)] * product;
  return product;
}

bool word_reaches(const LocalMatrices& local, const Word& word, const Rational& bound) {
  return spectral_radius_at_least(word_product(local, word),
                                  power(bound, static_cast<unsigned>(word.size())));
}

FactoredMask factored(const Mask& mask) {
  FactoredMask result{0, mask.symbol()};
  while (auto quotient = result.rest.divided_by_smoothing_factor(mask.arity())) {
    ++result.rules;
    result.rest = *std::move(quotient);
  }
  return result;
}

}  // namespace arete
