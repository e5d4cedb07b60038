// SPDX-License-Identifier: MIT
// Noise in the heights passes through natural neighbours, but does not grow on its way: not between
// points that lie close together, nor between the slivers along a hull, nor where the neighbours of
// a point lie near a line or a circle.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "clouds.h"

namespace arete {
namespace {

using test::Cloud;

double plane(double x, double y) { return 40 + 0.3 * x - 0.2 * y; }

// Where the i-th point lies, of two random numbers in 0..1.
using Place = std::function<WorldPoint(double, double)>;

struct Arrangement {
  const char* name;
  Place place;
};

constexpr double side = 1000;

const Arrangement arrangements[] = {
    {"even",
     [](double u, double v) {
       return WorldPoint{side * u, side * v};
     }},
    {"every tenth point with another 0.01 beside it",
     [last = WorldPoint{}](double u, double v) mutable {
       if (u < 0.1) return WorldPoint{last.x + 0.01 * v, last.y + 0.1 * u};
       return last = WorldPoint{side * u, side * v};
     }},
    {"a hull that bulges by 1e-4",
     [](double u, double v) {
       return u < 0.1 ? WorldPoint{side * v, -4e-4 * v * (1 - v)} : WorldPoint{side * u, side * v};
     }},
    {"lines of flight",
     [](double u, double v) {
       return WorldPoint{30 * std::floor(side * u / 30) + 0.5 * std::sin(1000 * u), side * v};
     }},
    {"clusters",
     [](double u, double v) {
       const double x = 100 * std::floor(10 * u);
       const double y = 100 * std::floor(10 * v);
       return WorldPoint{x + (1 + x / 100) * std::sin(1e4 * u), y + 2 * std::sin(1e4 * v)};
     }},
    {"a circle, but for rounding",
     [](double u, double v) {
       const double angle = 2 * std::numbers::pi * u;
       const double radius = 500 + 1e-6 * v;
       return WorldPoint{radius * std::cos(angle), radius * std::sin(angle)};
     }},
    {"a strip",
     [](double u, double v) {
       return WorldPoint{side * u, v};
     }},
};

Cloud arranged(const Arrangement& arrangement, int count, double noise, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0, 1);
  Cloud cloud;
  const Place place = arrangement.place;
  for (int i = 0; i < count; ++i) {
    const double u = share(random);
    const WorldPoint p = place(u, share(random));
    cloud.add(p.x, p.y, plane(p.x, p.y) + noise * (2 * share(random) - 1));
  }
  return cloud;
}

cgal::GriddedPoints gridded(const Cloud& cloud) {
  return grid_points(cloud.points(), {.size = Extent{150, 150}});
}

TEST(noise, of_a_plane_is_at_most_tripled) {
  for (const Arrangement& arrangement : arrangements)
    for (const int count : {60, 1000})
      for (unsigned seed = 1; seed <= 2; ++seed) {
        const auto grid = gridded(arranged(arrangement, count, 1, seed));
        EXPECT_LE(test::largest_difference(grid, plane), 3)
            << arrangement.name << ", " << count << " points, seed " << seed;
      }
}

TEST(noise, is_all_that_comes_between_the_surface_and_a_plane) {
  for (const Arrangement& arrangement : arrangements) {
    const auto grid = gridded(arranged(arrangement, 1000, 0, 1));
    EXPECT_LE(test::largest_difference(grid, plane), 1e-10) << arrangement.name;
  }
}

TEST(noise, that_is_doubled_doubles_its_trace) {
  // The surface is linear in the heights.
  const auto once = gridded(arranged(arrangements[0], 500, 1, 4));
  const auto twice = gridded(arranged(arrangements[0], 500, 2, 4));
  for (Index r = 0; r < once.heights.rows(); ++r)
    for (Index c = 0; c < once.heights.cols(); ++c) {
      if (std::isnan(once.heights(r, c))) continue;
      const WorldPoint p =
          once.georeference.position(static_cast<double>(r), static_cast<double>(c));
      const double flat = plane(p.x, p.y);
      ASSERT_NEAR(twice.heights(r, c) - flat, 2 * (once.heights(r, c) - flat), 1e-9);
    }
}

}  // namespace
}  // namespace arete
