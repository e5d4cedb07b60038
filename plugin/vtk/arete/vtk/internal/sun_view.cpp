// SPDX-License-Identifier: MIT
#include "arete/vtk/internal/sun_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace arete::vtk {
namespace {

constexpr double radian = std::numbers::pi / 180;
constexpr double disc_radius = 1;  // degrees; the sun's quarter of a degree looks cut out
constexpr double none = -std::numeric_limits<double>::infinity();

/// One sweep: lines of samples in the order in which light passes them, and where, one line back,
/// the ray to a sample came through.
struct Sweep {
  bool by_rows;   ///< lines are rows, otherwise columns
  bool forwards;  ///< from line 0 on
  double shift;   ///< position along the line before, minus that along this one
  double length;  ///< of the step in the plane

  /// Towards the light, in the plane: (x, y).
  Sweep(const Georeference& placement, double x, double y) {
    const auto& g = placement.affine;
    const double area = g[1] * g[5] - g[2] * g[4];
    const double d_col = (x * g[5] - y * g[2]) / area;
    const double d_row = (y * g[1] - x * g[4]) / area;
    by_rows = std::abs(d_row) >= std::abs(d_col);
    const double major = by_rows ? d_row : d_col;
    forwards = major < 0;
    shift = (by_rows ? d_col : d_row) / std::abs(major);
    length = std::hypot(x, y) / std::abs(major);
  }
};

/// Of a value that may be none, and the next one; where one is none, the other.
double between(double a, double b, double share) {
  if (a == none || share >= 1) return b;
  if (b == none || share <= 0) return a;
  return (1 - share) * a + share * b;
}

/// Rays side by side, one sample apart, from the first line to the last, and how high above each
/// line reaches the shadow that they carry.
class Rays {
 public:
  Rays(const Sweep& sweep, Index lines, Index count, double drop)
      : shift_(sweep.shift), count_(count), drop_(drop) {
    const double aside = std::ceil(std::abs(shift_) * static_cast<double>(lines - 1));
    origin_ = shift_ < 0 ? -aside : 0;
    edges_.assign(static_cast<std::size_t>(count) + static_cast<std::size_t>(aside) + 1, none);
  }

  /// The shadow's upper edge above sample k of the present line.
  [[nodiscard]] double edge(Index k) const {
    const double at = static_cast<double>(k) - position(0);
    const auto j = static_cast<std::size_t>(at);
    return between(edges_[j], edges_[j + 1], at - std::floor(at));
  }
  /// Goes on to the next line, over the heights (or none) of the present one.
  void pass(const std::vector<double>& heights) {
    for (std::size_t j = 0; j < edges_.size(); ++j) {
      const double at = position(j);
      if (at >= 0 && at <= static_cast<double>(count_ - 1)) {
        const auto k = static_cast<std::size_t>(at);
        const double next = k + 1 < heights.size() ? heights[k + 1] : none;
        edges_[j] = std::max(edges_[j], between(heights[k], next, at - std::floor(at)));
      }
      edges_[j] -= drop_;
    }
    ++line_;
  }

 private:
  /// Where ray j crosses the present line, in samples.
  [[nodiscard]] double position(std::size_t j) const {
    return static_cast<double>(j) + origin_ - static_cast<double>(line_) * shift_;
  }

  double shift_;
  Index count_;
  double drop_;
  double origin_;
  Index line_ = 0;
  std::vector<double> edges_;
};

}  // namespace

Grid<float> sun_view(const Surface& surface, const LocalPlane& plane, double exaggeration,
                     const Light& light) {
  const Extent extent = surface.extent();
  Grid<float> seen(extent, 1);
  const double upper = light.elevation + disc_radius;
  const double lower = std::max(light.elevation - disc_radius, 0.0);
  if (upper >= 89) return seen;
  const Sweep sweep(plane.placement, std::sin(light.azimuth * radian),
                    std::cos(light.azimuth * radian));
  const Index lines = sweep.by_rows ? extent.rows : extent.cols;
  const Index count = sweep.by_rows ? extent.cols : extent.rows;
  const auto drop = [&](double elevation) {
    return sweep.length * std::tan(elevation * radian) / exaggeration;
  };
  Rays by_upper(sweep, lines, count, drop(upper));  // where even the top of the disc is hidden
  Rays by_lower(sweep, lines, count, drop(lower));  // where its foot is
  std::vector<double> heights(static_cast<std::size_t>(count));
  for (Index step = 0; step < lines; ++step) {
    const Index line = sweep.forwards ? step : lines - 1 - step;
    for (Index k = 0; k < count; ++k) {
      const Index row = sweep.by_rows ? line : k;
      const Index col = sweep.by_rows ? k : line;
      const double height = surface.height(row, col);
      heights[static_cast<std::size_t>(k)] = std::isfinite(height) ? height : none;
      const double hidden_below = by_lower.edge(k);
      if (!std::isfinite(height) || height >= hidden_below) continue;
      const double dark_below = by_upper.edge(k);
      seen(row, col) = height > dark_below
                           ? static_cast<float>((height - dark_below) / (hidden_below - dark_below))
                           : 0.0F;
    }
    by_upper.pass(heights);
    by_lower.pass(heights);
  }
  return seen;
}

}  // namespace arete::vtk
