// SPDX-License-Identifier: MIT
#include "arete/vtk/plot_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "arete/vtk/error.h"
#include "pictures.h"
#include "support/temporary_folder.h"

namespace arete::vtk {
namespace {

ClassMap quarters() {
  ClassMap map{{"u", 0, 1}, {"v", -1, 1}, Grid<int>({2, 2}), {}};
  map.classes = {{"red", {200, 30, 30}},
                 {"green", {30, 200, 30}},
                 {"blue", {30, 30, 200}},
                 {"absent", {1, 2, 3}}};
  map.cells(0, 0) = 0;
  map.cells(0, 1) = 1;
  map.cells(1, 0) = 2;
  map.cells(1, 1) = 1;
  return map;
}

TEST(plot_map, row_0_is_at_the_bottom_and_cells_have_the_colours_of_their_classes) {
  const test::TemporaryFolder folder;
  plot_map(quarters(), {500, 400}, folder.file("map.png"));
  const Image picture = read_png(folder.file("map.png"));
  ASSERT_EQ(picture.width, 500);
  ASSERT_EQ(picture.height, 400);
  // Left of the middle of the plot, above and below its middle.
  EXPECT_EQ(picture(120, 100), (Rgb{30, 30, 200}));
  EXPECT_EQ(picture(120, 280), (Rgb{200, 30, 30}));
  std::map<Rgb, int> counts;
  for (const Rgb& pixel : picture.pixels) ++counts[pixel];
  // Two of four cells; the legend names what occurs and nothing else.
  EXPECT_NEAR(counts[(Rgb{30, 200, 30})], 2 * counts[(Rgb{30, 30, 200})], 500);
  EXPECT_EQ(counts.count(Rgb{1, 2, 3}), 0u);
}

// A disc of radius 0.3 around (0.5, 0) in shares of the axes, on a map of one colour.
TEST(plot_map, outlines_go_round_the_region_where_their_field_is_negative) {
  const test::TemporaryFolder folder;
  ClassMap map{{"u", 0, 1}, {"v", -1, 1}, Grid<int>({40, 40}), {}};
  map.classes = {{"pale", {250, 240, 200}}};
  MapOutline outline{"disc", {0, 0, 255}, Grid<double>({81, 81})};
  for (Index r = 0; r <= 80; ++r)
    for (Index c = 0; c <= 80; ++c)
      outline.field(r, c) =
          std::hypot(static_cast<double>(c) / 80 - 0.5, static_cast<double>(r) / 80 - 0.5) - 0.3;
  map.outlines = {outline};
  plot_map(map, {800, 800}, folder.file("whole.png"));
  // Only its upper half.
  map.outlines[0].within = Grid<double>({81, 81});
  for (Index r = 0; r <= 80; ++r)
    for (Index c = 0; c <= 80; ++c) map.outlines[0].within(r, c) = r > 40 ? -1 : 1;
  plot_map(map, {800, 800}, folder.file("half.png"));
  const auto blue_rows = [](const Image& picture) {
    std::pair<int, int> rows{picture.height, -1};
    // Not the legend, which is to the right of the plot.
    for (int row = 0; row < picture.height; ++row)
      for (int column = 0; column < 620; ++column) {
        const Rgb& pixel = picture(column, row);
        if (pixel[2] < 200 || pixel[0] > 80) continue;
        rows.first = std::min(rows.first, row);
        rows.second = std::max(rows.second, row);
      }
    return rows;
  };
  const auto whole = blue_rows(read_png(folder.file("whole.png")));
  const auto half = blue_rows(read_png(folder.file("half.png")));
  ASSERT_GT(whole.second, whole.first);
  // The disc's height is 0.6 of the plot's, which is 800 less margins of about 110 pixels.
  EXPECT_NEAR(whole.second - whole.first, 0.6 * 690, 25);
  EXPECT_EQ(half.first, whole.first);
  EXPECT_NEAR(half.second, (whole.first + whole.second) / 2.0, 12);

  map.outlines[0].field(3, 3) = std::nan("");
  EXPECT_THROW(plot_map(map, {800, 800}, folder.file("nan.png")), InvalidField);
}

TEST(plot_map, a_map_of_one_parameter_has_one_row) {
  const test::TemporaryFolder folder;
  ClassMap map{{"u", 0, 1}, {"", 0, 0}, Grid<int>({1, 2}), {}};
  map.classes = {{"red", {200, 30, 30}}, {"green", {30, 200, 30}}};
  map.cells(0, 1) = 1;
  MapOutline outline{"right of a quarter", {0, 0, 255}, Grid<double>({2, 5})};
  for (Index c = 0; c < 5; ++c)
    outline.field(0, c) = outline.field(1, c) = 0.25 - static_cast<double>(c) / 4;
  map.outlines = {outline};
  plot_map(map, {600, 250}, folder.file("strip.png"));
  const Image picture = read_png(folder.file("strip.png"));
  // Its edge goes all the way up.
  int blue = 0;
  for (int row = 0; row < picture.height; ++row)
    for (int column = 80; column < 330; ++column)
      if (picture(column, row)[2] > 200 && picture(column, row)[0] < 80) {
        ++blue;
        break;
      }
  EXPECT_GT(blue, 120);
  EXPECT_EQ(picture(120, 100), (Rgb{200, 30, 30}));
  EXPECT_EQ(picture(400, 100), (Rgb{30, 200, 30}));
}

TEST(plot_map, impossible_maps_are_refused) {
  const test::TemporaryFolder folder;
  ClassMap map = quarters();
  map.cells(0, 0) = 4;
  EXPECT_THROW(plot_map(map, {500, 400}, folder.file("m.png")), InvalidField);
  map = quarters();
  EXPECT_THROW(plot_map(map, {50, 400}, folder.file("m.png")), RenderError);
  map.cells = Grid<int>();
  EXPECT_THROW(plot_map(map, {500, 400}, folder.file("m.png")), InvalidField);
  EXPECT_EQ(folder.entries(), 0);
}

}  // namespace
}  // namespace arete::vtk
