// SPDX-License-Identifier: MIT
#include "arete/vtk/palette.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "arete/vtk/error.h"

namespace arete::vtk {
namespace {

constexpr Rgb green{0, 200, 0};
constexpr Rgb gray{100, 100, 100};
constexpr Rgb white{250, 250, 250};

Palette three_layers() {
  Palette palette;
  palette.layers = {{"grass", green},
                    {"rock", gray, 1, {}, Window{40, 90, 10}},
                    {"snow", white, 1, Window{0.8, 9, 0.2}, Window{0, 50, 0}}};
  return palette;
}

TEST(palette, a_window_is_whole_within_fades_evenly_on_both_sides_and_ends) {
  const Window window{2, 4, 1};
  EXPECT_EQ(window.weight(2), 1);
  EXPECT_EQ(window.weight(4), 1);
  EXPECT_EQ(window.weight(3), 1);
  EXPECT_EQ(window.weight(1), 0);
  EXPECT_EQ(window.weight(5), 0);
  EXPECT_DOUBLE_EQ(window.weight(1.5), 0.5);
  for (const double d : {0.1, 0.3, 0.5, 0.8}) {
    EXPECT_NEAR(window.weight(2 - d), window.weight(4 + d), 1e-12);
    EXPECT_NEAR(window.weight(2 - d) + window.weight(2 - (1 - d)), 1, 1e-12);
  }
  const Window hard{2, 4, 0};
  EXPECT_EQ(hard.weight(std::nextafter(2.0, 0.0)), 0);
  EXPECT_EQ(hard.weight(2), 1);
}

TEST(palette, later_layers_lie_over_earlier_ones_where_their_windows_hold) {
  const Palette palette = three_layers();
  EXPECT_EQ(palette({0.1, 5, 0}), green);
  EXPECT_EQ(palette({0.1, 60, 0}), gray) << "rock where it is steep";
  EXPECT_EQ(palette({0.9, 5, 0}), white) << "snow above";
  EXPECT_EQ(palette({0.9, 45, 0}), white) << "snow over rock";
  EXPECT_EQ(palette({0.9, 60, 0}), gray) << "but not where it slides off";
}

TEST(palette, half_a_weight_is_half_way_between_colours) {
  Palette palette = three_layers();
  EXPECT_EQ(palette({0.1, 35, 0}), (Rgb{50, 150, 50}));
  palette.layers[1].opacity = 0.5;
  EXPECT_EQ(palette({0.1, 60, 0}), (Rgb{50, 150, 50}));
}

TEST(palette, an_aspect_runs_clockwise_through_north_and_not_over_level_ground) {
  Palette palette;
  palette.layers = {{"sun", green}, {"shade", white, 1, {}, {}, Window{300, 60, 20}}};
  for (const double aspect : {300.0, 0.0, 60.0, 360.0, 720.0, -60.0})
    EXPECT_EQ(palette({0, 30, aspect}), white) << aspect;
  for (const double aspect : {80.0, 180.0, 280.0, -100.0})
    EXPECT_EQ(palette({0, 30, aspect}), green) << aspect;
  EXPECT_EQ(palette({0, 30, 70}), palette({0, 30, 290})) << "fades alike on both sides";
  EXPECT_EQ(palette({0, 0, 0}), green) << "level ground faces nowhere";
  palette.layers[1].aspect = Window{0, 360, 0};
  for (const double aspect : {0.0, 123.0, 360.0}) EXPECT_EQ(palette({0, 30, aspect}), white);
}

TEST(palette, those_that_are_built_in_are_sound_and_use_all_they_can) {
  for (const Palette& palette : palettes()) {
    EXPECT_NO_THROW(check(palette)) << palette.name;
    EXPECT_EQ(&find_palette(palette.name), &palette);
    EXPECT_NE(palette({0.1, 3, 0}), palette({0.9, 3, 0})) << palette.name << ": height";
    EXPECT_NE(palette({0.5, 3, 0}), palette({0.5, 60, 0})) << palette.name << ": slope";
  }
  const Palette& alpine = find_palette("alpine");
  EXPECT_NE(alpine({0.68, 25, 0}), alpine({0.68, 25, 180})) << "snow stays in the shade";
  EXPECT_GT(alpine({1, 3, 180})[2], 240) << "tops are white";
  EXPECT_LT(alpine({1, 60, 180})[2], 150) << "walls are not";
}

TEST(palette, what_is_unsound_is_named) {
  const auto message = [](auto change) {
    Palette palette = three_layers();
    change(palette);
    try {
      check(palette);
    } catch (const RenderError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const auto names = [&](auto change, const char* what) {
    const std::string text = message(change);
    EXPECT_NE(text.find(what), std::string::npos) << text;
  };
  EXPECT_EQ(message([](Palette&) {}), "");
  names([](Palette& p) { p.layers.clear(); }, "layer");
  names([](Palette& p) { p.layers[1].opacity = 1.5; }, "'rock': opacity");
  names([](Palette& p) { p.layers[2].height = Window{2, 1, 0}; }, "'snow', height");
  names([](Palette& p) { p.layers[1].slope->fade = -1; }, "'rock', slope");
  names(
      [](Palette& p) {
        p.layers[1].aspect = Window{0, std::numeric_limits<double>::infinity()};
      },
      "'rock', aspect");
  try {
    static_cast<void>(find_palette("plaid"));
    ADD_FAILURE();
  } catch (const RenderError& error) {
    for (const Palette& palette : palettes())
      EXPECT_NE(std::string(error.what()).find(palette.name), std::string::npos);
  }
}

}  // namespace
}  // namespace arete::vtk
