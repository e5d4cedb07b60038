// SPDX-License-Identifier: MIT
#include "arete/vtk/internal/reduce.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fixtures.h"

namespace arete::vtk {
namespace {

TEST(reduce, a_plane_stays_the_same_plane_in_the_world) {
  for (const Georeference& georeference : {north_up, south_up, rotated, sheared}) {
    for (const Extent extent : {Extent{11, 9}, {12, 12}, {2, 30}, {30, 3}, {13, 8}}) {
      const auto grid = planted<float>(extent, georeference, plane_height);
      const ReducedSurface reduced = reduce(surface_of(grid, georeference), 4);
      const Extent small = reduced.surface.extent();
      EXPECT_GE(small.rows, 2);
      EXPECT_LE(small.rows, 4);
      EXPECT_GE(small.cols, 2);
      EXPECT_LE(small.cols, 4);
      for (Index r = 0; r < small.rows; ++r) {
        for (Index c = 0; c < small.cols; ++c) {
          const WorldPoint at =
              reduced.surface.georeference.position(static_cast<double>(r), static_cast<double>(c));
          EXPECT_NEAR(reduced.surface.height(r, c), plane_height(at.x, at.y), 1e-9);
        }
      }
    }
  }
}

TEST(reduce, what_is_small_enough_is_borrowed_as_it_is) {
  const auto grid = planted<float>({4, 4}, north_up, plane_height);
  const ReducedSurface reduced = reduce(surface_of(grid, north_up), 4);
  EXPECT_EQ(reduced.factor, 1);
  EXPECT_EQ(std::get<GridView<const float>>(reduced.surface.heights).row(0), grid.row(0));
}

TEST(reduce, a_block_is_missing_when_most_of_it_is) {
  Grid<float> grid({4, 4}, 6);
  grid(0, 0) = grid(0, 1) = missing;               // half of the block is left
  grid(2, 2) = grid(2, 3) = grid(3, 2) = missing;  // a quarter
  const ReducedSurface reduced = reduce(surface_of(grid, north_up), 2);
  ASSERT_EQ(reduced.factor, 2);
  EXPECT_EQ(reduced.surface.height(0, 0), 6);
  EXPECT_TRUE(std::isnan(reduced.surface.height(1, 1)));
}

TEST(reduce, gradients_are_averaged_and_not_rescaled) {
  const Grid<float> grid({6, 6}, 0);
  auto east = planted<float>({6, 6}, north_up, [](double x, double) { return x; });
  const Grid<float> north({6, 6}, -2);
  Surface surface = surface_of(grid, north_up);
  surface.gradients.emplace(Gradients{std::as_const(east).view(), north.view()});
  const ReducedSurface reduced = reduce(surface, 3);
  ASSERT_TRUE(reduced.surface.gradients.has_value());
  EXPECT_EQ(reduced.surface.gradients->dz_dx(1, 1), (east(2, 2) + east(2, 3)) / 2);
  EXPECT_EQ(reduced.surface.gradients->dz_dy(1, 1), -2);
}

}  // namespace
}  // namespace arete::vtk
