// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "arete/topology/height_triangles.h"
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

/// Sets largest_error and left_out by a look at all samples and triangles.
template <class T>
void measure(GridView<const T> heights, HeightTriangles& mesh) {
  const Index cols = heights.cols();
  std::vector<bool> held(static_cast<std::size_t>(heights.rows() * cols), false);
  mesh.largest_error = 0;
  for (const auto& triangle : mesh.triangles) {
    std::array<LatticeTriangles::Corner, 3> corners;
    std::array<double, 3> z{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Index sample = mesh.samples[static_cast<std::size_t>(triangle[k])];
      corners[k] = {sample % cols, sample / cols};
      z[k] = static_cast<double>(heights(corners[k].y, corners[k].x));
    }
    for_each_sample(corners, [&](const auto& at, const std::array<double, 3>& share) {
      held[static_cast<std::size_t>(at.y * cols + at.x)] = true;
      const double error = std::abs(share[0] * z[0] + share[1] * z[1] + share[2] * z[2] -
                                    static_cast<double>(heights(at.y, at.x)));
      mesh.largest_error = std::max(mesh.largest_error, error);
    });
  }
  mesh.left_out = 0;
  for (Index r = 0; r < heights.rows(); ++r)
    for (Index c = 0; c < cols; ++c)
      if (std::isfinite(heights(r, c)) && !held[static_cast<std::size_t>(r * cols + c)])
        ++mesh.left_out;
}

}  // namespace arete
