// SPDX-License-Identifier: MIT
#include "arete/vtk/plot_map.h"

#include <gtest/gtest.h>

#include <map>

#include "arete/vtk/error.h"
#include "pictures.h"
#include "support/temporary_folder.h"

namespace arete::vtk {
namespace {

ClassMap quarters() {
  ClassMap map{{"u", 0, 1}, {"v", -1, 1}, Grid<int>({2, 2}), {}};
  map.classes = {{"red", {200, 30, 30}}, {"green", {30, 200, 30}}, {"blue", {30, 30, 200}},
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
