// SPDX-License-Identifier: MIT
#include "arete/fractal/arc_matrices.h"

#include "arete/fractal/address.h"

namespace arete {
namespace {

int floor_of(const Rational& value) { return static_cast<int>(floor(value)); }

}  // namespace

ArcMatrices arc_matrices(const Mask& mask) {
  const int m = mask.arity();
  const int first = floor_of(Rational(-mask.last()) / (m - 1)) + 1;
  const int last = -floor_of(Rational(mask.first()) / (m - 1) - 1) - 1;
  const int n = last - first + 1;
  ArcMatrices arcs{first, {}};
  for (int d = 0; d < m; ++d) {
    Matrix<Rational> map(n, n);
    for (int r = 0; r < n; ++r)
      for (int s = 0; s < n; ++s) map(r, s) = mask[d + first + r - m * (first + s)];
    arcs.set.maps.push_back(std::move(map));
  }
  return arcs;
}

std::optional<Stencil> limit_stencil_at(const Mask& mask, const Rational& x) {
  const ArcMatrices arcs = arc_matrices(mask);
  const Integer cell = floor(x);
  const auto row = limit_row(arcs.set, Rational(x - Rational(cell)), largest_expansion);
  if (!row) return std::nullopt;
  Stencil stencil{arcs.first + static_cast<int>(cell), *row};
  while (!stencil.weights.empty() && stencil.weights.back() == 0) stencil.weights.pop_back();
  while (!stencil.weights.empty() && stencil.weights.front() == 0) {
    stencil.weights.erase(stencil.weights.begin());
    ++stencil.first;
  }
  return stencil;
}

}  // namespace arete
