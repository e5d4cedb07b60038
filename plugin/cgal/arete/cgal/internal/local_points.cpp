// SPDX-License-Identifier: GPL-3.0-or-later
#include "arete/cgal/internal/local_points.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace arete::cgal::detail {
namespace {

bool finite(const ScatteredPoints& points, std::size_t i) {
  return std::isfinite(points.x[i]) && std::isfinite(points.y[i]) && std::isfinite(points.z[i]);
}

bool same_place(const LocalPoint& a, const LocalPoint& b) { return a.x == b.x && a.y == b.y; }

// Points at one place become one with their mean height. Sorted by height too, so that the mean
// does not depend on the order they came in.
Index merge(std::vector<LocalPoint>& points) {
  std::sort(points.begin(), points.end(), [](const LocalPoint& a, const LocalPoint& b) {
    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
  });
  std::size_t kept = 0;
  for (std::size_t first = 0; first < points.size();) {
    std::size_t last = first;
    double mean = 0;
    while (last < points.size() && same_place(points[first], points[last])) {
      ++last;
      mean += (points[last - 1].z - mean) / static_cast<double>(last - first);
    }
    points[kept++] = {points[first].x, points[first].y, mean};
    first = last;
  }
  const auto merged = static_cast<Index>(points.size() - kept);
  points.resize(kept);
  return merged;
}

}  // namespace

double LocalPoints::scaled(double length) const { return std::ldexp(length, -exponent); }

PlaneBox bounding_box(const ScatteredPoints& points) {
  if (points.x.size() != points.y.size() || points.x.size() != points.z.size())
    throw InvalidField("x, y and z of the points have " + std::to_string(points.x.size()) + ", " +
                       std::to_string(points.y.size()) + " and " + std::to_string(points.z.size()) +
                       " numbers; give equally many");
  bool any = false;
  PlaneBox box;
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    if (!finite(points, i)) continue;
    const double x = points.x[i];
    const double y = points.y[i];
    if (!any) box = {x, y, x, y};
    any = true;
    box = {std::min(box.x_min, x), std::min(box.y_min, y), std::max(box.x_max, x),
           std::max(box.y_max, y)};
  }
  if (!any)
    throw InvalidField(points.x.empty()
                           ? "there are no points; give at least three"
                           : "none of the " + std::to_string(points.x.size()) +
                                 " points has three finite coordinates; give at least three such");
  constexpr double largest = 1e150;
  if (box.x_max - box.x_min > largest || box.y_max - box.y_min > largest)
    throw InvalidField("the points are more than 1e150 apart; drop what is no coordinate");
  return box;
}

LocalPoints local_points(const ScatteredPoints& points) {
  LocalPoints local;
  local.box = bounding_box(points);
  local.origin = {local.box.x_min + (local.box.x_max - local.box.x_min) / 2,
                  local.box.y_min + (local.box.y_max - local.box.y_min) / 2};
  const double width =
      std::max(local.box.x_max - local.box.x_min, local.box.y_max - local.box.y_min);
  if (width > 0) local.exponent = std::ilogb(width);
  local.points.reserve(points.x.size());
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    if (!finite(points, i)) {
      ++local.not_finite;
      continue;
    }
    // Differences of numbers of one size are exact, and so is a power of two.
    local.points.push_back({local.scaled(points.x[i] - local.origin.x),
                            local.scaled(points.y[i] - local.origin.y), points.z[i]});
  }
  local.merged = merge(local.points);
  return local;
}

}  // namespace arete::cgal::detail
