// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "arete/algebra/matrix.h"
#include "arete/field/error.h"
#include "arete/variational/banded.h"

namespace arete {

/// The discrete harmonic function with the given values on the border of a grid: inside, every
/// value is the mean of its four neighbours. One coordinate of a surface; the values inside
/// `border` are not read.
///
/// This is the linear part of the minimal-surface problem: a minimal surface in isothermal
/// parameters has harmonic coordinates, and where these are harmonic polynomials of degree at most
/// three (Enneper's surface) the five-point equations reproduce it exactly. For a general boundary
/// it makes a good start, not a minimal surface. A banded solve over any field R, cost
/// O(rows cols min(rows, cols)^2). \throws InvalidField below 2 x 2 samples.
template <class R>
[[nodiscard]] Matrix<R> harmonic_patch(const Matrix<R>& border) {
  const int rows = border.rows() - 2;
  const int cols = border.cols() - 2;
  if (rows < 0 || cols < 0) throw InvalidField("a patch needs at least 2 x 2 samples");
  Matrix<R> patch = border;
  if (rows == 0 || cols == 0) return patch;
  const bool by_rows = cols <= rows;  // number along the shorter side: a narrower band
  const int short_side = by_rows ? cols : rows;
  const auto number = [&](int r, int c) -> Index {
    return by_rows ? static_cast<Index>(r) * cols + c : static_cast<Index>(c) * rows + r;
  };
  const Index unknowns = static_cast<Index>(rows) * cols;
  BandedSystem<R> system(unknowns, short_side, short_side);
  std::vector<R> values(static_cast<std::size_t>(unknowns), R(0));
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < cols; ++c) {
      const Index i = number(r, c);
      system.at(i, i) = R(4);
      const auto neighbour = [&](int nr, int nc) {
        if (nr >= 0 && nr < rows && nc >= 0 && nc < cols) {
          system.at(i, number(nr, nc)) = R(-1);
        } else {
          R& right = values[static_cast<std::size_t>(i)];
          right = right + border(nr + 1, nc + 1);
        }
      };
      neighbour(r - 1, c);
      neighbour(r + 1, c);
      neighbour(r, c - 1);
      neighbour(r, c + 1);
    }
  (void)system.factor();  // irreducibly diagonally dominant
  system.solve(values.data());
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < cols; ++c)
      patch(r + 1, c + 1) = values[static_cast<std::size_t>(number(r, c))];
  return patch;
}

}  // namespace arete
