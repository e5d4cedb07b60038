// SPDX-License-Identifier: MIT
#include "arete/vtk/image.h"

#include <gtest/gtest.h>

#include "arete/vtk/colormap.h"
#include "arete/vtk/error.h"
#include "fixtures.h"
#include "pictures.h"

namespace arete::vtk {
namespace {

Image striped(int width, int height) {
  Image image{width, height, {}};
  for (int k = 0; k < width * height; ++k) {
    image.pixels.push_back({static_cast<std::uint8_t>(k), static_cast<std::uint8_t>(3 * k), 7});
  }
  return image;
}

TEST(image, a_png_holds_every_pixel_in_its_place) {
  const Scratch scratch;
  const Image image = striped(17, 9);
  write_png(image, scratch / "a.png");
  const Image again = read_png(scratch / "a.png");
  ASSERT_EQ(again.width, 17);
  ASSERT_EQ(again.height, 9);
  EXPECT_EQ(again.pixels, image.pixels);
}

TEST(image, shrinking_keeps_uniform_colours) {
  for (int level = 0; level < 256; level += 5) {
    const auto v = static_cast<std::uint8_t>(level);
    const Image uniform{6, 4, std::vector<Rgb>(24, Rgb{v, 0, 255})};
    const Image small = shrink(uniform, 2);
    ASSERT_EQ(small.pixels.size(), 6u);
    for (const Rgb& pixel : small.pixels) {
      EXPECT_NEAR(pixel[0], level, 1);
      EXPECT_EQ(pixel[1], 0);
      EXPECT_EQ(pixel[2], 255);
    }
  }
}

TEST(image, shrinking_averages_light_and_not_codes) {
  const Image checks{2, 2, {{0, 0, 0}, {255, 255, 255}, {255, 255, 255}, {0, 0, 0}}};
  EXPECT_EQ(shrink(checks, 2)(0, 0)[0], 188);  // half the light in sRGB
}

TEST(image, refuses_what_is_no_picture_and_names_a_path_it_cannot_write) {
  const Scratch scratch;
  EXPECT_THROW(write_png({}, scratch / "a.png"), WriteError);
  EXPECT_THROW(write_png({2, 2, std::vector<Rgb>(3)}, scratch / "a.png"), WriteError);
  const auto path = scratch / "none/a.png";
  try {
    write_png(striped(2, 2), path);
    FAIL();
  } catch (const WriteError& error) {
    EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos) << error.what();
  }
}

TEST(colormap, runs_from_its_first_stop_to_its_last_and_is_linear_between) {
  for (const Colormap& map : colormaps()) {
    EXPECT_EQ(map.stops.front().at, 0);
    EXPECT_EQ(map.stops.back().at, 1);
    EXPECT_EQ(map(-1), map.stops.front().color);
    EXPECT_EQ(map(2), map.stops.back().color);
    for (std::size_t k = 1; k < map.stops.size(); ++k) {
      const ColorStop& a = map.stops[k - 1];
      const ColorStop& b = map.stops[k];
      ASSERT_LT(a.at, b.at) << map.name;
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(map((a.at + b.at) / 2)[c], (a.color[c] + b.color[c]) / 2.0, 0.5001) << map.name;
      }
    }
    EXPECT_EQ(&find_colormap(map.name), &map);
    EXPECT_FALSE(map.meaning.empty());
  }
}

TEST(colormap, the_even_ones_grow_ever_lighter) {
  for (const char* name : {"gray", "viridis", "magma", "glacier"}) {
    for (int k = 1; k <= 50; ++k) {
      EXPECT_GT(luma(find_colormap(name)(k / 50.0)), luma(find_colormap(name)((k - 1) / 50.0)))
          << name << " at " << k;
    }
  }
}

TEST(colormap, an_unknown_name_is_answered_with_those_there_are) {
  try {
    static_cast<void>(find_colormap("rainbow"));
    FAIL();
  } catch (const RenderError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("rainbow"), std::string::npos);
    for (const Colormap& map : colormaps()) {
      EXPECT_NE(message.find(map.name), std::string::npos) << message;
    }
  }
}

}  // namespace
}  // namespace arete::vtk
