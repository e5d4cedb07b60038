// SPDX-License-Identifier: MIT
// What is refused, and by whom.
#include "arete/vtk/surface.h"

#include <gtest/gtest.h>

#include "fixtures.h"

namespace arete::vtk {
namespace {

std::string refusal(void (*check)(const Surface&), const Surface& surface) {
  try {
    check(surface);
  } catch (const InvalidField& error) {
    return error.what();
  }
  return "";
}

TEST(surface, an_ordinary_one_passes) {
  for (const Georeference& georeference : {north_up, rotated, sheared, utm}) {
    const auto grid = planted<float>({2, 2}, georeference, plane_height);
    EXPECT_EQ(refusal(check_geometry, surface_of(grid, georeference)), "");
  }
}

TEST(surface, geometry_needs_two_rows_and_two_columns) {
  for (const Extent extent : {Extent{1, 5}, {5, 1}, {1, 1}}) {
    const Grid<float> grid(extent, 1);
    EXPECT_NE(refusal(check_geometry, surface_of(grid, north_up)).find("2 x 2"), std::string::npos);
    EXPECT_EQ(refusal(check_samples, surface_of(grid, north_up)), "");
  }
  const Grid<float> empty(Extent{0, 5});
  EXPECT_NE(refusal(check_samples, surface_of(empty, north_up)), "");
}

TEST(surface, geometry_needs_a_valid_sample) {
  Grid<float> grid({3, 3}, missing);
  EXPECT_NE(refusal(check_geometry, surface_of(grid, north_up)), "");
  EXPECT_EQ(refusal(check_samples, surface_of(grid, north_up)), "");
  grid(2, 2) = 0;
  EXPECT_EQ(refusal(check_geometry, surface_of(grid, north_up)), "");
}

TEST(surface, gradients_fit_the_heights) {
  const Grid<float> grid({3, 4}, 1);
  const Grid<float> other({4, 3}, 1);
  Surface surface = surface_of(grid, north_up);
  surface.gradients.emplace(Gradients{grid.view(), other.view()});
  EXPECT_NE(refusal(check_samples, surface), "");
  surface.gradients.emplace(Gradients{grid.view(), grid.view()});
  EXPECT_EQ(refusal(check_samples, surface), "");
}

TEST(surface, the_georeference_spans_a_plane) {
  const Grid<float> grid({3, 4}, 1);
  const Georeference line{{0, 1, 2, 0, 2, 4}};
  const Georeference point{{0, 0, 0, 0, 0, 0}};
  const Georeference broken{{0, 1, 0, missing, 0, 1}};
  EXPECT_NE(refusal(check_geometry, surface_of(grid, line)), "");
  EXPECT_NE(refusal(check_geometry, surface_of(grid, point)), "");
  EXPECT_NE(refusal(check_samples, surface_of(grid, broken)), "");
}

TEST(surface, a_geographic_one_keeps_away_from_the_poles) {
  const Grid<float> grid({3, 4}, 1);
  const Georeference pole{{0, 1, 0, 91.5, 0, -1}};
  Surface surface = surface_of(grid, pole);
  EXPECT_EQ(refusal(check_geometry, surface), "");
  surface.coordinates = Coordinates::geographic;
  EXPECT_NE(refusal(check_geometry, surface).find("gdalwarp"), std::string::npos);
  surface.georeference = jacksboro;
  EXPECT_EQ(refusal(check_geometry, surface), "");
}

TEST(surface, notes_have_names) {
  const Grid<float> grid({3, 4}, 1);
  Surface surface = surface_of(grid, north_up);
  surface.notes = {{"", "text"}};
  EXPECT_NE(refusal(check_samples, surface), "");
}

}  // namespace
}  // namespace arete::vtk
