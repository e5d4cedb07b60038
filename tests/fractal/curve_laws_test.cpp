// SPDX-License-Identifier: MIT
// Laws of curves that hold for every scheme.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "arete/refine/curve.h"
#include "support/schemes.h"

namespace arete {
namespace {

Grid<double> some_polygon(Index n) {
  Grid<double> points({n, 3});
  for (Index i = 0; i < n; ++i) {
    const auto t = static_cast<double>(i);
    points(i, 0) = 3 * std::cos(1.1 * t) + 0.1 * t;
    points(i, 1) = 2 * std::sin(0.7 * t + 0.3);
    points(i, 2) = std::fmod(t * 0.61803, 1.0);
  }
  return points;
}

// A rotation about an axis in general position, and a shift.
Grid<double> moved(const Grid<double>& points) {
  const double c = std::cos(0.8), s = std::sin(0.8), d = std::cos(-0.4), e = std::sin(-0.4);
  Grid<double> result(points.extent());
  for (Index r = 0; r < points.rows(); ++r) {
    const double x = c * points(r, 0) - s * points(r, 1);
    const double y = s * points(r, 0) + c * points(r, 1);
    result(r, 0) = x + 5;
    result(r, 1) = d * y - e * points(r, 2) - 2;
    result(r, 2) = e * y + d * points(r, 2) + 1;
  }
  return result;
}

double largest_difference(const Grid<double>& a, const Grid<double>& b) {
  EXPECT_EQ(a.extent(), b.extent());
  double largest = 0;
  for (std::size_t i = 0; i < a.samples().size(); ++i)
    largest = std::max(largest, std::abs(a.samples()[i] - b.samples()[i]));
  return largest;
}

TEST(curve_laws, rotate_then_refine_is_refine_then_rotate) {
  const Grid<double> polygon = some_polygon(17);
  for (const Scheme& scheme : test::sample_schemes())
    for (const bool closed : {false, true}) {
      const CurveOptions options{2, closed, Boundary::extrapolate};
      const auto fine = refine_curve<double>(polygon.view(), scheme, options).points;
      const auto turned = refine_curve<double>(moved(polygon).view(), scheme, options).points;
      double size = 10;  // ghosts of linear extrapolation grow with a scheme's reach
      for (const double x : fine.samples()) size = std::max(size, std::abs(x));
      EXPECT_LT(largest_difference(turned, moved(fine)), 1e-12 * size / 10) << scheme.text();
    }
}

TEST(curve_laws, a_closed_curve_does_not_care_where_it_begins_to_the_last_bit) {
  const Grid<double> polygon = some_polygon(9);
  Grid<double> relabelled(polygon.extent());
  const Index by = 4;
  for (Index r = 0; r < 9; ++r)
    for (Index c = 0; c < 3; ++c) relabelled(r, c) = polygon((r + by) % 9, c);
  for (const Scheme& scheme : test::sample_schemes()) {
    const CurveOptions options{2, /*closed=*/true, {}};
    const auto fine = refine_curve<double>(polygon.view(), scheme, options).points;
    const auto other = refine_curve<double>(relabelled.view(), scheme, options).points;
    const Index factor = fine.rows() / 9;
    for (Index r = 0; r < fine.rows(); ++r)
      for (Index c = 0; c < 3; ++c)
        ASSERT_EQ(other(r, c), fine((r + by * factor) % fine.rows(), c)) << scheme.text();
  }
}

TEST(curve_laws, degenerate_polygons_stay_what_they_are) {
  for (const Scheme& scheme : test::sample_schemes()) {
    SCOPED_TRACE(scheme.text());
    // One point, and repeated points: that point.
    for (const Index n : {1, 2, 5}) {
      const Grid<double> same({n, 2}, 7.25);
      for (const bool closed : {false, true}) {
        const auto fine =
            refine_curve<double>(same.view(), scheme, {1, closed, Boundary::extrapolate}).points;
        EXPECT_GE(fine.rows(), 1);
        for (const double x : fine.samples()) EXPECT_NEAR(x, 7.25, 1e-13);
      }
    }
    // Collinear points stay on their line, two points too.
    for (const Index n : {2, 6}) {
      Grid<double> line({n, 2});
      for (Index i = 0; i < n; ++i) {
        line(i, 0) = static_cast<double>(i * i);
        line(i, 1) = 3 * static_cast<double>(i * i) - 1;
      }
      const auto fine =
          refine_curve<double>(line.view(), scheme, {2, false, Boundary::extrapolate}).points;
      for (Index r = 0; r < fine.rows(); ++r)
        EXPECT_NEAR(fine(r, 1), 3 * fine(r, 0) - 1, 1e-12 * (10 + std::abs(fine(r, 0))));
    }
  }
}

}  // namespace
}  // namespace arete
