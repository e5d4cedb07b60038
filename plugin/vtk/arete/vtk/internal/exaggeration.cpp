// SPDX-License-Identifier: MIT
#include "arete/vtk/internal/exaggeration.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "arete/vtk/internal/gradient.h"

namespace arete::vtk {
namespace {

// Found by looking at pictures of mountains, hills and plains.
constexpr double wanted_steepness = 0.45;  // root mean square of the gradient
constexpr double most_relief = 0.16;       // height range per length of the plan's diagonal

double two_digits(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return std::round(value / unit) * unit;
}

}  // namespace

double choose_exaggeration(const Surface& surface, const LocalPlane& plane) {
  const Extent extent = surface.extent();
  const GradientField gradients(surface, plane);
  double squares = 0;
  Index count = 0;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (Index r = 0; r < extent.rows; ++r) {
    for (Index c = 0; c < extent.cols; ++c) {
      if (!surface.valid(r, c)) continue;
      const Gradient g = gradients.at(r, c);
      squares += g.dx * g.dx + g.dy * g.dy;
      low = std::min(low, surface.height(r, c));
      high = std::max(high, surface.height(r, c));
      ++count;
    }
  }
  const double steepness = std::sqrt(squares / static_cast<double>(std::max<Index>(count, 1)));
  if (!(steepness > 0) || !(high > low)) return 1;
  const auto& g = plane.placement.affine;
  const auto rows = static_cast<double>(extent.rows - 1);
  const auto cols = static_cast<double>(extent.cols - 1);
  const double diagonal = std::hypot(cols * g[1] + rows * g[2], cols * g[4] + rows * g[5]);
  return two_digits(std::min(wanted_steepness / steepness, most_relief * diagonal / (high - low)));
}

}  // namespace arete::vtk
