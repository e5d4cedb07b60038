// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "arete/topology/lattice_triangles.h"

namespace arete {

/// Calls visit(sample, shares) for every sample of a triangle, edges and corners included; shares
/// are its barycentric coordinates, of sum 1. \pre the area is positive.
template <class Visit>
void for_each_sample(const std::array<LatticeTriangles::Corner, 3>& corners, const Visit& visit) {
  using Corner = LatticeTriangles::Corner;
  const auto& [a, b, c] = corners;
  const auto whole = static_cast<double>(LatticeTriangles::area(a, b, c));
  const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
  const auto [left, right] = std::minmax({a.x, b.x, c.x});
  const auto floor_ratio = [](Index n, Index d) {
    return n / d - (n % d != 0 && (n < 0) != (d < 0));
  };
  for (Index y = top; y <= bottom; ++y) {
    Index first = left;
    Index end = right;
    // Left of no edge: slope (x - left) + at_left >= 0, in integers.
    for (std::size_t k = 0; k < 3; ++k) {
      const Corner& p = corners[(k + 1) % 3];
      const Corner& q = corners[(k + 2) % 3];
      const Index slope = p.y - q.y;
      const Index at_left = LatticeTriangles::area(p, q, {left, y});
      if (slope > 0) first = std::max(first, left - floor_ratio(at_left, slope));
      if (slope < 0) end = std::min(end, left + floor_ratio(at_left, -slope));
    }
    for (Index x = first; x <= end; ++x) {
      const Corner at{x, y};
      const double second = static_cast<double>(LatticeTriangles::area(c, a, at)) / whole;
      const double third = static_cast<double>(LatticeTriangles::area(a, b, at)) / whole;
      visit(at, std::array<double, 3>{1 - second - third, second, third});
    }
  }
}

/// Which samples lie in (or on edges of) those triangles that keep(number) says.
template <class T, class Keep>
std::vector<bool> held_samples(GridView<const T> heights, const LatticeTriangles& mesh,
                               const Keep& keep) {
  const Index cols = heights.cols();
  std::vector<bool> held(static_cast<std::size_t>(heights.rows() * cols), false);
  for (int t = 0; t < mesh.count(); ++t) {
    if (!keep(t)) continue;
    for_each_sample(mesh.corners(t), [&](const auto& at, const auto&) {
      held[static_cast<std::size_t>(at.y * cols + at.x)] = true;
    });
  }
  return held;
}

}  // namespace arete
