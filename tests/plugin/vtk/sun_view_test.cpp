// SPDX-License-Identifier: MIT
#include "arete/vtk/internal/sun_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fixtures.h"

namespace arete::vtk {
namespace {

constexpr double radian = std::numbers::pi / 180;
const Georeference unit{{0, 1, 0, 60, 0, -1}};  // x = col + 1/2, y = 60 - row - 1/2

Grid<float> seen_over(const Grid<float>& grid, const Light& light, double exaggeration = 1,
                      const Georeference& georeference = unit) {
  const Surface surface = surface_of(grid, georeference);
  return sun_view(surface, local_plane(surface), exaggeration, light);
}

TEST(sun_view, level_ground_and_slopes_towards_the_light_are_lit) {
  for (const double azimuth : {0.0, 37.0, 90.0, 200.0, 315.0}) {
    const Grid<float> level = seen_over(Grid<float>({20, 30}, 7), {azimuth, 20});
    for (const double share : level.samples()) EXPECT_EQ(share, 1);
    const double x = std::sin(azimuth * radian);
    const double y = std::cos(azimuth * radian);
    const auto towards = planted<float>(
        {20, 30}, unit, [&](double px, double py) { return -0.5 * (px * x + py * y); });
    const Grid<float> slope = seen_over(towards, {azimuth, 5});
    for (const double share : slope.samples()) EXPECT_EQ(share, 1);
  }
}

TEST(sun_view, a_slope_steeper_away_than_the_light_is_dark) {
  // Falls by 1 a unit northwards; light from the south at 30 degrees passes over it.
  const auto away = planted<float>({40, 40}, unit, [](double, double y) { return -y; });
  const auto seen = seen_over(away, {180, 30});
  for (Index c = 0; c < 40; ++c) {
    EXPECT_EQ(seen(39, c), 1) << "nothing stands before the southern edge";
    EXPECT_EQ(seen(10, c), 0);
  }
}

TEST(sun_view, a_wall_s_shadow_is_as_long_as_the_light_is_low) {
  // A wall of height 10 across the raster, light over it from each side in turn.
  for (const double azimuth : {0.0, 90.0, 180.0, 270.0}) {
    const bool along_y = azimuth == 0 || azimuth == 180;
    const double sign = azimuth == 0 || azimuth == 90 ? -1 : 1;  // where the shadow falls
    const auto wall = planted<float>({61, 61}, unit, [&](double x, double y) {
      return std::abs((along_y ? y : x) - 30.5) < 0.4 ? 10 : 0;
    });
    const double elevation = 40;
    const double length = 10 / std::tan(elevation * radian);  // 11.9
    const auto seen = seen_over(wall, {azimuth, elevation});
    const auto at = [&](double from_wall) {
      const auto step = static_cast<Index>(std::lround(sign * from_wall));
      return along_y ? seen(29 - step, 30) : seen(30, 30 + step);
    };
    EXPECT_EQ(at(0), 1) << azimuth << ": the top of the wall";
    for (Index k = 2; k <= 11; ++k) EXPECT_EQ(at(static_cast<double>(k)), 0) << azimuth << " " << k;
    for (Index k = 14; k < 28; ++k) EXPECT_EQ(at(static_cast<double>(k)), 1) << azimuth << " " << k;
    for (Index k = 1; k < 28; ++k) EXPECT_EQ(at(-static_cast<double>(k)), 1) << azimuth << " " << k;
    EXPECT_NEAR(length, 11.9, 0.1);
  }
}

TEST(sun_view, exaggeration_makes_shadows_longer) {
  const auto wall = planted<float>(
      {61, 61}, unit, [](double x, double) { return std::abs(x - 30.5) < 0.4 ? 5 : 0; });
  const auto dark = [&](double exaggeration) {
    const auto seen = seen_over(wall, {270, 45}, exaggeration);
    double sum = 0;
    for (Index c = 0; c < 61; ++c) sum += 1 - seen(30, c);
    return sum;
  };
  EXPECT_NEAR(dark(1), 5, 1);
  EXPECT_NEAR(dark(3), 15, 1.5);
}

TEST(sun_view, a_slanting_light_s_shadow_lies_where_its_ray_comes_down) {
  // A tower of 3 x 3 samples; rays from the north-west by 20 degrees off the diagonal.
  Grid<float> tower({61, 61}, 0);
  for (Index r = 19; r <= 21; ++r)
    for (Index c = 19; c <= 21; ++c) tower(r, c) = 12;
  const double azimuth = 295;
  const double elevation = 35;
  const auto seen = seen_over(tower, {azimuth, elevation});
  const double length = 0.7 * 12 / std::tan(elevation * radian);  // well within the shadow
  const auto row = static_cast<Index>(std::lround(20 + length * std::cos(azimuth * radian)));
  const auto col = static_cast<Index>(std::lround(20 - length * std::sin(azimuth * radian)));
  EXPECT_LT(seen(row, col), 0.1);
  EXPECT_EQ(seen(2 * 20 - row, 2 * 20 - col), 1) << "the other side is lit";
  EXPECT_EQ(seen(row - 8, col), 1);
  EXPECT_EQ(seen(row + 8, col), 1);
}

TEST(sun_view, long_shadows_have_softer_edges) {
  const auto soft = [](float height) {
    const auto wall = planted<float>({200, 200}, Georeference{{0, 1, 0, 200, 0, -1}},
                                     [&](double x, double) { return x < 20 ? height : 0; });
    const auto seen = seen_over(wall, {270, 20}, 1, Georeference{{0, 1, 0, 200, 0, -1}});
    int between = 0;
    for (Index c = 0; c < 200; ++c) between += seen(100, c) > 0 && seen(100, c) < 1 ? 1 : 0;
    return between;
  };
  EXPECT_GT(soft(40), soft(10));
  EXPECT_GT(soft(10), 0);
}

TEST(sun_view, light_passes_over_missing_samples) {
  Grid<float> wall({40, 40}, 0);
  for (Index r = 0; r < 40; ++r) wall(r, 10) = 10;
  wall(20, 12) = missing;
  const auto seen = seen_over(wall, {270, 45});
  EXPECT_EQ(seen(20, 15), 0) << "the wall's shadow goes on behind a hole";
  Grid<float> gap = wall;
  for (Index r = 0; r < 40; ++r) gap(r, 10) = missing;
  EXPECT_EQ(seen_over(gap, {270, 45})(20, 15), 1) << "what is not there throws no shadow";
}

}  // namespace
}  // namespace arete::vtk
