// SPDX-License-Identifier: MIT
#include "arete/variational/boundary_loop.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include "arete/variational/natural_spline.h"

namespace arete {
namespace {

using Curve = std::function<Point3(double)>;

double distance(const Point3& a, const Point3& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// Lengths from the first point to each; of a closed one back to the first as the last entry.
std::vector<double> lengths_along(const std::vector<Point3>& points, bool closed) {
  std::vector<double> lengths{0};
  for (std::size_t i = 1; i < points.size() + (closed ? 1 : 0); ++i)
    lengths.push_back(lengths.back() + distance(points[i - 1], points[i % points.size()]));
  return lengths;
}

// The polygon by its length, t in 0..1.
Curve polygon(const std::vector<Point3>& points, bool closed) {
  return [points, lengths = lengths_along(points, closed)](double t) {
    const double at = t * lengths.back();
    const auto above = std::upper_bound(lengths.begin() + 1, lengths.end() - 1, at);
    const auto i = static_cast<std::size_t>(above - lengths.begin());
    const double span = lengths[i] - lengths[i - 1];
    const double share = span > 0 ? (at - lengths[i - 1]) / span : 0;
    const Point3& a = points[i - 1];
    const Point3& b = points[i % points.size()];
    Point3 result{};
    for (std::size_t k = 0; k < 3; ++k) result[k] = (1 - share) * a[k] + share * b[k];
    return result;
  };
}

// The cubic spline through the points, uniform in their numbers.
Curve spline(const std::vector<Point3>& points, bool closed) {
  Matrix<double> table(static_cast<int>(points.size()), 3);
  for (int r = 0; r < table.rows(); ++r)
    for (int c = 0; c < 3; ++c)
      table(r, c) = points[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)];
  const auto fit = std::make_shared<NaturalSpline<double>>(
      table, closed ? SplineEnds::closed : SplineEnds::natural);
  const int pieces = table.rows() - (closed ? 0 : 1);
  return [fit, pieces](double t) {
    const double at = t * pieces;
    const int knot = std::clamp(static_cast<int>(at), 0, pieces - 1);
    const std::vector<double> value = fit->value(knot, at - knot);
    return Point3{value[0], value[1], value[2]};
  };
}

Curve curve_through(const std::vector<Point3>& points, bool closed, bool smooth) {
  return smooth ? spline(points, closed) : polygon(points, closed);
}

std::vector<int> quarter_points(const std::vector<Point3>& loop) {
  const std::vector<double> lengths = lengths_along(loop, /*closed=*/true);
  const auto n = static_cast<int>(loop.size());
  std::vector<int> corners{0};
  for (int side = 1; side < 4; ++side) {
    const double wanted = lengths.back() * side / 4;
    int best = corners.back() + 1;
    for (int i = best; i <= n - (4 - side); ++i)
      if (std::abs(lengths[static_cast<std::size_t>(i)] - wanted) <
          std::abs(lengths[static_cast<std::size_t>(best)] - wanted))
        best = i;
    corners.push_back(best);
  }
  return corners;
}

void check_loop(const std::vector<Point3>& loop, std::size_t least, const char* what) {
  if (loop.size() < least)
    throw InvalidField(std::string("the boundary has ") + std::to_string(loop.size()) +
                       " points; " + what + " needs at least " + std::to_string(least));
  if (!(lengths_along(loop, true).back() > 0))
    throw InvalidField("all points of the boundary are the same; give a closed loop");
}

void check_corners(const std::vector<int>& corners, int count) {
  bool good = corners.size() == 4;
  for (std::size_t i = 0; good && i < 4; ++i)
    good = corners[i] >= 0 && corners[i] < count && (i == 0 || corners[i] > corners[i - 1]);
  if (!good)
    throw InvalidField("a patch needs four increasing corners from 0 to " +
                       std::to_string(count - 1) + ", as in 0,10,20,30");
}

}  // namespace

PatchBoundary patch_boundary(const std::vector<Point3>& loop, const std::vector<int>& corners,
                             bool smooth) {
  check_loop(loop, 4, "a patch with four sides");
  const auto count = static_cast<int>(loop.size());
  const std::vector<int> at = corners.empty() ? quarter_points(loop) : corners;
  check_corners(at, count);
  std::array<Curve, 4> sides;
  for (std::size_t side = 0; side < 4; ++side) {
    const int last = side < 3 ? at[side + 1] : at[0] + count;
    std::vector<Point3> points;
    for (int i = at[side]; i <= last; ++i)
      points.push_back(loop[static_cast<std::size_t>(i % count)]);
    sides[side] = curve_through(points, /*closed=*/false, smooth);
  }
  // Once around: v = 0 forwards, u = 1 upwards, v = 1 backwards, u = 0 downwards.
  return {[sides](double u, double v) {
    if (v == 0) return sides[0](u);
    if (u == 1) return sides[1](v);
    if (v == 1) return sides[2](1 - u);
    return sides[3](1 - v);
  }};
}

PatchBoundary ring_boundary(const std::vector<Point3>& first, const std::vector<Point3>& second,
                            bool smooth) {
  check_loop(first, 3, "a ring");
  check_loop(second, 3, "a ring");
  const Curve bottom = curve_through(first, true, smooth);
  const Curve top = curve_through(second, true, smooth);
  // Of all beginnings of the second loop, both ways around, the one with the least squares.
  constexpr int samples = 128;
  const auto place = [](double t) { return t - std::floor(t); };
  double least = std::numeric_limits<double>::infinity();
  double shift = 0;
  double way = 1;
  for (const double direction : {1.0, -1.0})
    for (int offset = 0; offset < samples; ++offset) {
      double sum = 0;
      for (int i = 0; i < samples; ++i) {
        const double t = static_cast<double>(i) / samples;
        const double d =
            distance(bottom(t), top(place(direction * t + static_cast<double>(offset) / samples)));
        sum += d * d;
      }
      if (sum < least) {
        least = sum;
        shift = static_cast<double>(offset) / samples;
        way = direction;
      }
    }
  return {[bottom, top, place, shift, way](double u, double v) {
            return v == 0 ? bottom(u) : top(place(way * u + shift));
          },
          /*ring=*/true};
}

}  // namespace arete
