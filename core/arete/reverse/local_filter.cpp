// SPDX-License-Identifier: MIT
#include "arete/reverse/local_filter.h"

#include "arete/algebra/linear_solve.h"

namespace arete {

Stencil local_filter(const Mask& mask, IndexRange window) {
  const LevelRule rule{mask.arity(), mask.symbol()};
  const IndexRange coarse = rule.needed(window);
  const int rows = static_cast<int>(window.count());
  const int cols = static_cast<int>(coarse.count());
  Matrix<Rational> s(rows, cols);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < cols; ++j)
      s(i, j) = mask[static_cast<int>(window.first + i - rule.arity * (coarse.first + j))];
  Matrix<Rational> gram(cols, cols);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < cols; ++j)
      for (int k = 0; k < cols; ++k) gram(j, k) += s(i, j) * s(i, k);
  std::vector<Rational> unit(static_cast<std::size_t>(cols), Rational(0));
  const bool inside = coarse.first <= 0 && coarse.last >= 0;
  if (inside) unit[static_cast<std::size_t>(-coarse.first)] = 1;
  const auto solution = inside ? solve_unique(gram, unit) : std::nullopt;
  if (!solution)
    throw InvalidScheme("the fine samples " + std::to_string(window.first) + ".." +
                        std::to_string(window.last) +
                        " do not determine the coarse samples they read through the mask " +
                        coefficients_text(mask) + "; give a longer or shifted window");
  Stencil filter{static_cast<int>(window.first), {}};
  for (int i = 0; i < rows; ++i) {
    Rational weight = 0;
    for (int j = 0; j < cols; ++j) weight += s(i, j) * (*solution)[static_cast<std::size_t>(j)];
    filter.weights.push_back(weight);
  }
  return filter;
}

}  // namespace arete
