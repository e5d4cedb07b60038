// SPDX-License-Identifier: MIT
#include "arete/vtk/internal/sky_view.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fixtures.h"

namespace arete::vtk {
namespace {

const Georeference unit{{0, 1, 0, 0, 0, 1}};

Grid<float> sky_over(const Grid<float>& grid, double exaggeration) {
  const Surface surface = surface_of(grid, unit);
  return sky_view(surface, local_plane(surface), exaggeration);
}

TEST(sky_view, level_ground_sees_the_whole_sky_also_beside_holes) {
  Grid<float> grid({9, 9}, 3);
  grid(4, 5) = missing;
  const Grid<float> sky = sky_over(grid, 10);
  for (const float share : sky.samples()) EXPECT_EQ(share, 1);
}

TEST(sky_view, the_foot_of_an_endless_wall_loses_what_the_wall_hides) {
  // A cliff of height 1 one sample east: of eight directions three meet it, at distances 1, sqrt 2
  // and sqrt 2; what each hides is the sine of its elevation.
  const auto grid = planted<float>({9, 9}, unit, [](double x, double) { return x > 5 ? 1 : 0; });
  const auto sky = sky_over(grid, 2);
  const double hidden = (2 / std::sqrt(5.0) + 2 * std::sqrt(2.0) / std::sqrt(3.0)) / 8;
  EXPECT_NEAR(sky(4, 4), 1 - hidden, 1e-6);
  EXPECT_EQ(sky(4, 5), 1) << "from the top nothing hides";
  EXPECT_GT(sky(4, 1), sky(4, 4)) << "the cliff sinks with distance";
}

}  // namespace
}  // namespace arete::vtk
