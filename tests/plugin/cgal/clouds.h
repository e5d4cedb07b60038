// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <random>
#include <vector>

#include "arete/cgal/scattered_grid.h"

namespace arete::test {

/// Points owned by a test.
struct Cloud {
  std::vector<double> x, y, z;

  void add(double px, double py, double pz) {
    x.push_back(px);
    y.push_back(py);
    z.push_back(pz);
  }
  [[nodiscard]] cgal::ScatteredPoints points() const { return {x, y, z}; }
};

using Height = std::function<double(double, double)>;

/// Random points in a box about (x0, y0), its corners among them, with the heights of a function.
inline Cloud random_cloud(int count, const Height& height, double side = 100, double x0 = 0,
                          double y0 = 0, unsigned seed = 5) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0, side);
  Cloud cloud;
  const auto add = [&](double x, double y) { cloud.add(x0 + x, y0 + y, height(x0 + x, y0 + y)); };
  for (const double x : {0.0, side})
    for (const double y : {0.0, side}) add(x, y);
  for (int i = 0; i < count; ++i) {
    const double x = place(random);
    add(x, place(random));
  }
  return cloud;
}

/// The largest distance of the grid from a function, over the samples that have a height and
/// satisfy the condition.
inline double largest_difference(
    const cgal::GriddedPoints& grid, const Height& height,
    const std::function<bool(double, double)>& where = [](double, double) { return true; }) {
  double largest = 0;
  for (Index r = 0; r < grid.heights.rows(); ++r)
    for (Index c = 0; c < grid.heights.cols(); ++c) {
      const WorldPoint p =
          grid.georeference.position(static_cast<double>(r), static_cast<double>(c));
      if (std::isnan(grid.heights(r, c)) || !where(p.x, p.y)) continue;
      largest = std::max(largest, std::abs(grid.heights(r, c) - height(p.x, p.y)));
    }
  return largest;
}

}  // namespace arete::test
