// SPDX-License-Identifier: MIT
// Light, material, palettes, textures and cameras in pictures.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "arete/vtk/error.h"
#include "arete/vtk/render.h"
#include "fixtures.h"
#include "models.h"

namespace arete::vtk {
namespace {

constexpr Rgb magenta{255, 0, 255};
constexpr Extent extent{60, 60};
const Georeference unit{{0, 1, 0, 60, 0, -1}};

class RenderLook : public testing::Test {
 protected:
  void SetUp() override {
    unsetenv("DISPLAY");
    options_.width = 240;
    options_.height = 200;
    options_.view = View::map;
    options_.background = magenta;
    options_.color_bar = false;
    options_.appearance.colormap = "clay";
    options_.exaggeration = 1;
  }

  Image draw(const Surface& surface) {
    const Scratch scratch;
    render(surface, options_, scratch / "a.png");
    return read_png(scratch / "a.png");
  }
  Image draw(const Grid<float>& grid) { return draw(surface_of(grid, unit)); }

  /// The mean over a part of the terrain, given by shares of its box in a map.
  static double bright(const Image& image, double x0, double y0, double x1, double y1) {
    const Box box = box_of(image, [](const Rgb& pixel) { return pixel != magenta; });
    const auto at = [](int low, int length, double share) {
      return low + static_cast<int>(share * (length - 1));
    };
    return mean_luma(image, {at(box.x0, box.width(), x0), at(box.y0, box.height(), y0),
                             at(box.x0, box.width(), x1), at(box.y0, box.height(), y1)});
  }
  static double bright(const Image& image) { return bright(image, 0.1, 0.1, 0.9, 0.9); }

  RenderOptions options_;
};

/// A wall across the middle of a plain, running north.
Grid<float> wall() {
  return planted<float>(extent, unit,
                        [](double x, double) { return std::abs(x - 30) < 2 ? 8 : 0; });
}

TEST_F(RenderLook, shadows_fall_away_from_the_light_and_nowhere_else) {
  options_.lights = {{270, 30}};
  const Image without = draw(wall());
  options_.shadows = true;
  const Image with = draw(wall());
  // The wall's shadow is 8 / tan 30 = 14 long; beyond the wall's foot, east of 32.
  EXPECT_LT(bright(with, 0.6, 0.2, 0.7, 0.8), bright(without, 0.6, 0.2, 0.7, 0.8) - 50);
  EXPECT_GT(bright(with, 0.6, 0.2, 0.7, 0.8), 30) << "dark and not black";
  EXPECT_NEAR(bright(with, 0.85, 0.2, 0.95, 0.8), bright(without, 0.85, 0.2, 0.95, 0.8), 1);
  EXPECT_NEAR(bright(with, 0.1, 0.2, 0.4, 0.8), bright(without, 0.1, 0.2, 0.4, 0.8), 1);
}

TEST_F(RenderLook, a_second_light_fills_the_shadow_of_the_first) {
  options_.shadows = true;
  options_.lights = {{270, 30}};
  const double dark = bright(draw(wall()), 0.6, 0.2, 0.7, 0.8);
  options_.lights.push_back({90, 30, 0.5, {255, 255, 255}});
  const Image both = draw(wall());
  EXPECT_GT(bright(both, 0.6, 0.2, 0.7, 0.8), dark + 20);
}

TEST_F(RenderLook, light_has_intensity_and_colour) {
  const Grid<float> level(extent, 1);
  options_.lights = {{0, 60, 0.6, {255, 255, 255}}};
  options_.material = {0.1, 0.6, 0, 15};
  const Image white = draw(level);
  options_.lights[0].intensity = 1.2;
  EXPECT_GT(bright(draw(level)), bright(white) * 1.3);
  options_.lights[0] = {0, 60, 0.6, {255, 0, 0}};
  const Image red = draw(level);
  const Rgb before = white(120, 100);
  const Rgb after = red(120, 100);
  EXPECT_NEAR(after[0], before[0], 1);
  EXPECT_LT(after[1], before[1] / 2);
}

TEST_F(RenderLook, ambient_and_diffuse_are_shares_that_add_up) {
  const Grid<float> level(extent, 1);
  options_.lights = {{0, 90, 1, {255, 255, 255}}};
  const auto at = [&](double ambient, double diffuse) {
    options_.material = {ambient, diffuse, 0, 15};
    return bright(draw(level));
  };
  const double ambient = at(0.4, 0);
  const double diffuse = at(0, 0.4);
  EXPECT_NEAR(at(0.4, 0.4), ambient + diffuse, 2);
  EXPECT_NEAR(at(0.2, 0), ambient / 2, 2);
  options_.lights.clear();
  EXPECT_NEAR(at(0.4, 0), ambient, 1) << "ambient light needs no lamp";
}

TEST_F(RenderLook, highlights_are_the_specular_share_and_not_in_a_map) {
  const auto dome = planted<float>(extent, unit, [](double x, double y) {
    return -((x - 30) * (x - 30) + (y - 30) * (y - 30)) / 60;
  });
  options_.lights = {{180, 60}};
  options_.material = {0.2, 0.4, 0, 20};
  options_.view = View::oblique;
  const double dull = bright(draw(dome));
  options_.material.specular = 0.6;
  EXPECT_GT(bright(draw(dome)), dull + 2);
  options_.view = View::map;
  const Image map = draw(dome);
  options_.material.specular = 0;
  EXPECT_EQ(draw(dome).pixels, map.pixels);
}

TEST_F(RenderLook, a_palette_colours_by_slope_and_height) {
  // A plain, a cliff in the middle, a plateau.
  const auto step = planted<float>(
      extent, unit, [](double x, double) { return std::clamp((x - 27) * 4, 0.0, 24.0); });
  Palette palette;
  palette.layers = {{"grass", {0, 200, 0}},
                    {"snow", {230, 230, 230}, 1, Window{0.9, 2, 0}},
                    {"rock", {200, 0, 0}, 1, {}, Window{60, 90, 5}}};
  options_.appearance.palette = palette;
  options_.material = {1, 0, 0, 15};  // colours as they are, but for what sky view takes
  const Image image = draw(step);
  const Box box = box_of(image, [](const Rgb& pixel) { return pixel != magenta; });
  const auto at = [&](double x) {
    return image(box.x0 + static_cast<int>(x * box.width()), (box.y0 + box.y1) / 2);
  };
  const auto leads = [](const Rgb& color, std::size_t c) {
    return color[c] > 2 * color[(c + 1) % 3] && color[c] > 2 * color[(c + 2) % 3];
  };
  EXPECT_TRUE(leads(at(0.2), 1)) << "grass below";
  EXPECT_TRUE(leads(at(0.5), 0)) << "rock on the cliff";
  EXPECT_NEAR(at(0.8)[0], at(0.8)[1], 2) << "snow above";
  EXPECT_GT(at(0.8)[0], 200);
}

TEST_F(RenderLook, slopes_are_those_drawn_unless_the_palette_wants_the_terrain_s) {
  const auto ramp = planted<float>(extent, unit, [](double x, double) { return 0.5 * x; });  // 27
  Palette palette;
  palette.layers = {{"grass", {0, 200, 0}}, {"rock", {200, 0, 0}, 1, {}, Window{40, 90, 0}}};
  options_.material = {1, 0, 0, 15};
  options_.exaggeration = 3;  // 56 degrees
  options_.appearance.palette = palette;
  EXPECT_GT(draw(ramp)(120, 100)[0], 100);
  options_.appearance.palette->drawn_slopes = false;
  EXPECT_EQ(draw(ramp)(120, 100)[0], 0);
}

TEST_F(RenderLook, ground_shows_where_a_texture_is_not) {
  const Grid<float> level(extent, 1);
  options_.material = {1, 0, 0, 15};
  Palette palette;
  palette.layers = {{"grass", {0, 200, 0}}};
  options_.appearance.palette = palette;
  Texture texture{Image{2, 1, {{200, 0, 0}, {200, 0, 0}}}, {255, 0}};
  options_.appearance.texture = texture;
  const Image image = draw(level);
  const Box box = box_of(image, [](const Rgb& pixel) { return pixel != magenta; });
  const int middle = (box.y0 + box.y1) / 2;
  EXPECT_EQ(image(box.x0 + 10, middle), (Rgb{200, 0, 0}));
  EXPECT_EQ(image(box.x1 - 10, middle), (Rgb{0, 200, 0}));
}

TEST_F(RenderLook, a_texture_stays_in_place_when_samples_are_averaged) {
  // 61 samples a side: averaging by four leaves one out, and the texture still covers all 61.
  const Georeference fine{{0, 1, 0, 61, 0, -1}};
  const Grid<float> level({61, 61}, 1);
  options_.material = {1, 0, 0, 15};
  options_.appearance.texture = Texture{four_colors(122)};
  const auto border = [&](Index most) {
    options_.most_samples = most;
    const Image image = draw(surface_of(level, fine));
    const Box box = box_of(image, [](const Rgb& pixel) { return pixel != magenta; });
    const int y = box.y0 + box.height() / 4;
    int x = box.x0;
    while (image(x, y)[0] > 100) ++x;
    return static_cast<double>(x - box.x0) / box.width();
  };
  EXPECT_NEAR(border(2000), 0.5, 0.01);
  // 15 blocks of 4, the first sample left out on the far side: from sample 1.5 to 57.5, the middle
  // of the box, 30, at 28.5 / 56.
  EXPECT_NEAR(border(16), 28.5 / 56, 0.012);
}

TEST_F(RenderLook, a_legend_names_the_layers_of_a_palette) {
  const Grid<float> level(extent, 1);
  options_.width = 500;
  options_.height = 300;
  options_.view = View::oblique;
  Palette palette;
  palette.layers = {{"grass", {0, 200, 0}}, {"snow", {0, 0, 250}, 1, Window{5, 6, 0}}};
  options_.appearance.palette = palette;
  options_.color_bar = true;
  const Image image = draw(level);
  int blue = 0;  // snow lies nowhere but in the legend
  for (const Rgb& pixel : image.pixels) blue += pixel == Rgb{0, 0, 250} ? 1 : 0;
  EXPECT_GT(blue, 20);
  const Box all = box_of(image, [](const Rgb& pixel) { return pixel != magenta; });
  EXPECT_LT(all.x1, image.width - 1) << "nothing is cut off";
}

TEST_F(RenderLook, a_turntable_shows_all_sides_from_one_distance_and_comes_round) {
  const auto ramp = planted<float>(extent, unit, [](double x, double) { return x / 3; });
  options_.view = View::oblique;
  options_.azimuth = 0;
  options_.lights = {{270, 20}};
  const Scratch scratch;
  std::vector<std::filesystem::path> paths;
  render_turntable(surface_of(ramp, unit), options_, 4, [&](int frame) {
    EXPECT_EQ(frame, static_cast<int>(paths.size()));
    paths.push_back(scratch / (std::to_string(frame) + ".png"));
    return paths.back();
  });
  ASSERT_EQ(paths.size(), 4u);
  std::vector<Image> images;
  for (const auto& path : paths) images.push_back(read_png(path));
  for (const Image& image : images) {
    EXPECT_EQ(image.width, 240);
    const Box box = box_of(image, [](const Rgb& pixel) { return pixel != magenta; });
    EXPECT_GT(box.width(), 100);
    EXPECT_GT(box.x0, 0);
    EXPECT_LT(box.x1, 239);
  }
  EXPECT_NE(images[0].pixels, images[2].pixels);
  // From the west one looks up the ramp, from the east at the wall under its upper edge.
  const auto high_side = [&](const Image& image) {
    const Box box = box_of(image, [](const Rgb& pixel) { return pixel != magenta; });
    return box.height();
  };
  EXPECT_NE(high_side(images[1]), high_side(images[3]));
  options_.azimuth = 90;
  std::vector<std::filesystem::path> again;
  render_turntable(surface_of(ramp, unit), options_, 4, [&](int frame) {
    return again.emplace_back(scratch / ("again" + std::to_string(frame) + ".png"));
  });
  EXPECT_EQ(read_png(again[0]).pixels, images[1].pixels) << "frame 1 of 4 is a quarter further";
}

TEST_F(RenderLook, a_turntable_refuses_what_does_not_turn) {
  const Grid<float> level(extent, 1);
  const auto nowhere = [](int) -> std::filesystem::path { throw std::logic_error("drawn"); };
  EXPECT_THROW(render_turntable(surface_of(level, unit), options_, 4, nowhere), RenderError);
  options_.view = View::oblique;
  EXPECT_THROW(render_turntable(surface_of(level, unit), options_, 0, nowhere), RenderError);
}

TEST_F(RenderLook, a_jpeg_is_the_same_picture_in_fewer_bytes) {
  const Scratch scratch;
  const auto surface = wall();
  const Image png = draw(surface);
  render(surface_of(surface, unit), options_, scratch / "a.JPG");
  const std::string bytes = contents(scratch / "a.JPG");
  EXPECT_EQ(bytes.substr(0, 3), "\xFF\xD8\xFF");
}

}  // namespace
}  // namespace arete::vtk
