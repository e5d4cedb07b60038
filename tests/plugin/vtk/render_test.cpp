// SPDX-License-Identifier: MIT
#include "arete/vtk/render.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "arete/vtk/colormap.h"
#include "arete/vtk/error.h"
#include "fixtures.h"
#include "pictures.h"

namespace arete::vtk {
namespace {

constexpr Rgb magenta{255, 0, 255};  // no colormap has it, no light makes it
constexpr Extent extent{60, 60};
const Georeference unit{{0, 1, 0, 60, 0, -1}};

/// Pictures of a few thousand pixels; no display is to be had in any of these tests.
class Render : public testing::Test {
 protected:
  void SetUp() override { unsetenv("DISPLAY"); }

  static RenderOptions small_options(View view) {
    RenderOptions options;
    options.width = 240;
    options.height = 160;
    options.view = view;
    options.background = magenta;
    options.color_bar = false;
    return options;
  }

  Image draw(const Surface& surface, const RenderOptions& options) {
    const Scratch scratch;
    report_ = render(surface, options, scratch / "a.png");
    return read_png(scratch / "a.png");
  }

  RenderReport report_;
};

bool is_drawn(const Rgb& pixel) { return pixel != magenta; }

/// The part of a picture's box given by shares of its width and height.
Box part(const Box& box, double x0, double y0, double x1, double y1) {
  const auto at = [](int low, int length, double share) {
    return low + static_cast<int>(std::lround(share * (length - 1)));
  };
  return {at(box.x0, box.width(), x0), at(box.y0, box.height(), y0), at(box.x0, box.width(), x1),
          at(box.y0, box.height(), y1)};
}

double hill(double x, double y) {
  return 8 * std::exp(-((x - 30) * (x - 30) + (y - 30) * (y - 30)) / 200);
}

TEST_F(Render, gives_a_picture_of_the_asked_size_without_a_display) {
  const auto grid = planted<float>(extent, unit, hill);
  for (const View view : {View::oblique, View::map}) {
    RenderOptions options = small_options(view);
    options.width = 333;
    options.height = 211;
    const Image image = draw(surface_of(grid, unit), options);
    EXPECT_EQ(image.width, 333);
    EXPECT_EQ(image.height, 211);
    EXPECT_EQ(report_.platform, "EGL");
    const Box box = box_of(image, is_drawn);
    EXPECT_GT(box.width() * box.height(), 333 * 211 / 3) << "the terrain fills its picture";
    EXPECT_GT(box.x0, 0) << "and keeps off the edge";
    EXPECT_GT(box.y0, 0);
    EXPECT_LT(box.x1, 332);
    EXPECT_LT(box.y1, 210);
  }
}

TEST_F(Render, the_same_surface_gives_the_same_picture) {
  const auto grid = planted<float>(extent, unit, hill);
  const RenderOptions options = small_options(View::oblique);
  EXPECT_EQ(draw(surface_of(grid, unit), options).pixels,
            draw(surface_of(grid, unit), options).pixels);
}

// A roof with a ridge; its two sides are alike but for the light.
TEST_F(Render, a_slope_that_faces_the_light_is_brighter) {
  const auto ridge_north_south =
      planted<float>(extent, unit, [](double x, double) { return -std::abs(x - 30); });
  const auto ridge_east_west =
      planted<float>(extent, unit, [](double, double y) { return -std::abs(y - 30); });
  const auto halves = [&](const Grid<float>& grid, double azimuth, double elevation) {
    RenderOptions options = small_options(View::map);
    options.appearance.colormap = "clay";
    options.lights[0].azimuth = azimuth;
    options.lights[0].elevation = elevation;
    const Image image = draw(surface_of(grid, unit), options);
    const Box box = box_of(image, is_drawn);
    struct {
      double west, east, north, south;
    } halves{mean_luma(image, part(box, 0.1, 0.1, 0.4, 0.9)),
             mean_luma(image, part(box, 0.6, 0.1, 0.9, 0.9)),
             mean_luma(image, part(box, 0.1, 0.1, 0.9, 0.4)),
             mean_luma(image, part(box, 0.1, 0.6, 0.9, 0.9))};
    return halves;
  };
  const auto from_west = halves(ridge_north_south, 270, 40);
  EXPECT_GT(from_west.west, from_west.east + 30);
  const auto from_east = halves(ridge_north_south, 90, 40);
  EXPECT_GT(from_east.east, from_east.west + 30);
  const auto from_north = halves(ridge_east_west, 0, 40);
  EXPECT_GT(from_north.north, from_north.south + 30);
  const auto from_south = halves(ridge_east_west, 180, 40);
  EXPECT_GT(from_south.south, from_south.north + 30);
  for (const auto& [a, b] :
       {std::pair{from_west.west, from_east.east}, {from_north.north, from_south.south}}) {
    EXPECT_NEAR(a, b, 3) << "the light alone decides";
  }
}

TEST_F(Render, what_no_light_reaches_is_dark_and_not_black) {
  const auto cliff = planted<float>(extent, unit, [](double x, double) { return -x; });
  RenderOptions options = small_options(View::map);
  options.appearance.colormap = "clay";
  options.exaggeration = 5;  // 79 degrees, away from a light that nearly lies on the ground
  options.lights[0].azimuth = 270;
  options.lights[0].elevation = 1;
  const Image image = draw(surface_of(cliff, unit), options);
  const double brightness = mean_luma(image, part(box_of(image, is_drawn), 0.2, 0.2, 0.8, 0.8));
  EXPECT_GT(brightness, 50);
  EXPECT_LT(brightness, 130);
}

TEST_F(Render, given_gradients_shade_a_level_surface) {
  const Grid<float> level(extent, 5);
  const Grid<float> up_east(extent, 1);
  const Grid<float> none(extent, 0);
  RenderOptions options = small_options(View::map);
  options.lights[0].azimuth = 270;
  options.exaggeration = 1;
  Surface surface = surface_of(level, unit);
  const auto brightness = [&] {
    const Image image = draw(surface, options);
    return mean_luma(image, part(box_of(image, is_drawn), 0.2, 0.2, 0.8, 0.8));
  };
  const double by_heights = brightness();
  surface.gradients.emplace(Gradients{up_east.view(), none.view()});
  EXPECT_GT(brightness(), by_heights + 10) << "rising eastwards, it faces the light in the west";
}

TEST_F(Render, north_is_up_and_east_right_whichever_way_the_raster_runs) {
  for (const Georeference& georeference :
       {unit, Georeference{{0, 1, 0, 0, 0, 1}}, Georeference{{60, -1, 0, 60, 0, -1}},
        Georeference{{0, 0, 1, 0, 1, 0}}}) {
    for (const bool northwards : {true, false}) {
      const auto grid = planted<float>(extent, georeference,
                                       [&](double x, double y) { return northwards ? y : x; });
      RenderOptions options = small_options(View::map);
      options.appearance.colormap = "gray";
      const Image image = draw(surface_of(grid, georeference), options);
      const Box box = box_of(image, is_drawn);
      const double low = mean_luma(
          image, northwards ? part(box, 0.1, 0.8, 0.9, 0.9) : part(box, 0.1, 0.1, 0.2, 0.9));
      const double high = mean_luma(
          image, northwards ? part(box, 0.1, 0.1, 0.9, 0.2) : part(box, 0.8, 0.1, 0.9, 0.9));
      EXPECT_GT(high, low + 50) << (northwards ? "north" : "east");
    }
  }
}

TEST_F(Render, a_map_keeps_proportions) {
  const Georeference wide{{0, 3, 0, 60, 0, -1}};
  const auto grid = planted<float>({31, 21}, wide, hill);  // 60 wide, 30 high
  const Box box = box_of(draw(surface_of(grid, wide), small_options(View::map)), is_drawn);
  EXPECT_NEAR(static_cast<double>(box.width()) / box.height(), 2, 0.03);
}

TEST_F(Render, holes_show_the_background) {
  auto grid = planted<float>(extent, unit, hill);
  for (const View view : {View::map, View::oblique}) {
    const auto middle = [&](const Grid<float>& heights) {
      RenderOptions options = small_options(view);
      options.exaggeration = 0.2;  // so that the near rim of the hole does not hide it
      const Image image = draw(surface_of(heights, unit), options);
      const Box box = box_of(image, is_drawn);
      return image((box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2);
    };
    auto holed = grid;
    for (Index r = 20; r < 40; ++r) {
      for (Index c = 20; c < 40; ++c) holed(r, c) = missing;
    }
    EXPECT_NE(middle(grid), magenta);
    EXPECT_EQ(middle(holed), magenta);
  }
}

TEST_F(Render, a_hole_is_as_large_as_its_missing_quads) {
  auto grid = planted<float>(extent, unit, [](double, double) { return 0; });
  grid(10, 10) = missing;  // four quads of 59 x 59
  const Image image = draw(surface_of(grid, unit), small_options(View::map));
  const Box box = box_of(image, is_drawn);
  int holes = 0;
  for (int y = box.y0; y <= box.y1; ++y) {
    for (int x = box.x0; x <= box.x1; ++x) holes += image(x, y) == magenta ? 1 : 0;
  }
  const double quad = box.width() * box.height() / (59.0 * 59.0);
  EXPECT_GT(holes, 1.5 * quad);  // pixels of the hole's edge are mixed
  EXPECT_LT(holes, 4.1 * quad);
}

TEST_F(Render, colours_follow_the_height_and_the_range) {
  const auto grid = planted<float>(extent, unit, [](double x, double) { return x; });
  RenderOptions options = small_options(View::map);
  options.appearance.colormap = "viridis";
  options.lights[0].elevation = 90;
  const auto redder_east = [&] {
    const Image image = draw(surface_of(grid, unit), options);
    const Box box = box_of(image, is_drawn);
    const Rgb& west = image(box.x0 + 5, (box.y0 + box.y1) / 2);
    const Rgb& east = image(box.x1 - 5, (box.y0 + box.y1) / 2);
    return east[0] - west[0];
  };
  EXPECT_GT(redder_east(), 100) << "violet to yellow";
  EXPECT_NEAR(report_.lowest, 0.5, 1e-6);
  EXPECT_NEAR(report_.highest, 59.5, 1e-6);
  options.appearance.range = {{1000, 2000}};
  EXPECT_NEAR(redder_east(), 0, 3) << "all below the range";
  EXPECT_EQ(report_.lowest, 1000);
}

TEST_F(Render, automatic_exaggeration_undoes_the_units) {
  const auto grid = planted<float>(extent, unit, hill);
  const RenderOptions options = small_options(View::oblique);
  draw(surface_of(grid, unit), options);
  const double chosen = report_.exaggeration;
  EXPECT_GT(chosen, 0);

  const auto tenfold =
      planted<float>(extent, unit, [](double x, double y) { return 10 * hill(x, y); });
  draw(surface_of(tenfold, unit), options);
  EXPECT_NEAR(report_.exaggeration, chosen / 10, 1e-9 * chosen);

  const Georeference thousandfold{{0, 1000, 0, 60000, 0, -1000}};
  draw(surface_of(grid, thousandfold), options);
  EXPECT_NEAR(report_.exaggeration, chosen * 1000, 1e-6 * chosen);

  RenderOptions fixed = options;
  fixed.exaggeration = 2.5;
  draw(surface_of(grid, unit), fixed);
  EXPECT_EQ(report_.exaggeration, 2.5);
}

TEST_F(Render, twice_the_height_is_the_height_exaggerated_twice) {
  const auto grid = planted<float>(extent, unit, hill);
  const auto doubled =
      planted<float>(extent, unit, [](double x, double y) { return 2 * hill(x, y); });
  RenderOptions twice = small_options(View::oblique);
  twice.exaggeration = 2;
  RenderOptions once = twice;
  once.exaggeration = 1;
  const Image expected = draw(surface_of(doubled, unit), once);
  EXPECT_EQ(draw(surface_of(grid, unit), twice).pixels, expected.pixels);
  EXPECT_NE(draw(surface_of(grid, unit), once).pixels, expected.pixels);
}

TEST_F(Render, large_rasters_are_averaged_down_and_that_is_told) {
  const Georeference fine{{0, 0.01, 0, 22, 0, -0.01}};
  const auto grid = planted<float>({2200, 2100}, fine, [](double x, double y) { return x + y; });
  draw(surface_of(grid, fine), small_options(View::map));
  EXPECT_EQ(report_.reduction, 2);
  EXPECT_EQ(report_.drawn, (Extent{1100, 1050}));
  const auto whole = planted<float>(extent, unit, hill);
  draw(surface_of(whole, unit), small_options(View::map));
  EXPECT_EQ(report_.reduction, 1);
  EXPECT_EQ(report_.drawn, extent);
}

TEST_F(Render, the_colour_bar_stands_clear_of_the_terrain) {
  const Georeference wide{{0, 3, 0, 60, 0, -1}};
  for (const Georeference& georeference : {unit, wide}) {
    const auto grid = planted<float>(extent, georeference, hill);
    for (const View view : {View::oblique, View::map}) {
      RenderOptions options = small_options(view);
      options.width = 400;
      options.height = 260;
      options.color_bar = true;
      const Image image = draw(surface_of(grid, georeference), options);
      // Runs of columns with something in them: terrain, a gap, the bar and its labels.
      const auto empty = [&](int x) {
        for (int y = 0; y < image.height; ++y) {
          if (is_drawn(image(x, y))) return false;
        }
        return true;
      };
      const Box all = box_of(image, is_drawn);
      int widest_gap = 0;
      int gap_start = 0;
      for (int x = all.x0, run = 0; x <= all.x1; ++x) {
        run = empty(x) ? run + 1 : 0;
        if (run > widest_gap) {
          widest_gap = run;
          gap_start = x - run + 1;
        }
      }
      EXPECT_GE(widest_gap, 4);
      EXPECT_GT(gap_start - all.x0, 100) << "the terrain is left of the gap";
      EXPECT_GT(all.x1 - gap_start - widest_gap, 20) << "the bar is right of it";
      EXPECT_LT(all.x1, image.width - 1) << "labels are not cut off";
    }
  }
}

TEST_F(Render, a_texture_covers_the_raster_s_box_north_up) {
  const Scratch scratch;
  const Rgb red{230, 0, 0};
  const Rgb green{0, 230, 0};
  const Rgb blue{0, 0, 230};
  const Rgb white{230, 230, 230};
  Image quarters{64, 64, {}};
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      quarters.pixels.push_back(y < 32 ? (x < 32 ? red : green) : (x < 32 ? blue : white));
    }
  }
  const auto grid = planted<float>(extent, unit, [](double, double) { return 0; });
  RenderOptions options = small_options(View::map);
  options.appearance.texture = Texture{quarters};
  options.color_bar = true;  // there is none all the same: colours no longer mean heights
  const Image image = draw(surface_of(grid, unit), options);
  const Box box = box_of(image, is_drawn);
  EXPECT_NEAR(box.width(), box.height(), 3) << "a square and nothing beside it";
  const auto at = [&](double x, double y) {
    const Box one = part(box, x, y, x, y);
    return image(one.x0, one.y0);
  };
  const auto only = [](const Rgb& pixel, std::size_t channel) {
    for (std::size_t c = 0; c < 3; ++c) {
      if (c != channel && pixel[c] * 2 > pixel[channel]) return false;
    }
    return pixel[channel] > 100;
  };
  for (const double near : {0.1, 0.4}) {
    for (const double far : {0.6, 0.9}) {
      EXPECT_TRUE(only(at(near, near), 0)) << "red in the north-west";
      EXPECT_TRUE(only(at(far, near), 1)) << "green in the north-east";
      EXPECT_TRUE(only(at(near, far), 2)) << "blue in the south-west";
    }
  }
}

TEST_F(Render, level_ground_and_two_by_two_are_ordinary) {
  const Grid<float> level(extent, 123.25f);
  draw(surface_of(level, unit), small_options(View::oblique));
  EXPECT_EQ(report_.exaggeration, 1);
  EXPECT_EQ(report_.lowest, 123.25);
  EXPECT_EQ(report_.highest, 123.25);
  RenderOptions with_bar = small_options(View::map);
  with_bar.color_bar = true;
  const Image image = draw(surface_of(level, unit), with_bar);
  EXPECT_GT(box_of(image, is_drawn).width(), 100);

  const auto tiny = planted<double>({2, 2}, unit, plane_height);
  const Image two = draw(surface_of(tiny, unit), small_options(View::oblique));
  EXPECT_GT(box_of(two, is_drawn).width(), 100);
}

TEST_F(Render, far_from_the_origin_nothing_jitters) {
  // In single precision these coordinates would be 32 apart.
  const Georeference far{{5e8, 1, 0, 7e8 + 60, 0, -1}};
  const auto grid = planted<double>(extent, unit, hill);
  const RenderOptions options = small_options(View::oblique);
  const Image here = draw(surface_of(grid, unit), options);
  const Image there = draw(surface_of(grid, far), options);
  int different = 0;
  for (std::size_t k = 0; k < here.pixels.size(); ++k) {
    different += std::abs(luma(here.pixels[k]) - luma(there.pixels[k])) > 2 ? 1 : 0;
  }
  EXPECT_EQ(different, 0);
}

TEST_F(Render, prints_nothing) {
  const auto grid = planted<float>(extent, unit, hill);
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  draw(surface_of(grid, unit), small_options(View::oblique));
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(Render, refuses_what_is_no_surface) {
  const Scratch scratch;
  const auto refused = [&](const Grid<float>& grid) {
    EXPECT_THROW(render(surface_of(grid, unit), small_options(View::map), scratch / "a.png"),
                 InvalidField);
    EXPECT_FALSE(std::filesystem::exists(scratch / "a.png"));
  };
  refused(Grid<float>({1, 50}, 1));
  refused(Grid<float>({50, 1}, 1));
  refused(Grid<float>(extent, missing));
  Grid<float> scattered(extent, missing);
  for (Index k = 0; k < 60; ++k) scattered(k, k) = 1;
  refused(scattered);
}

TEST_F(Render, refuses_options_out_of_range_and_paths_that_are_none) {
  const Scratch scratch;
  const auto grid = planted<float>(extent, unit, hill);
  const auto message = [&](auto change, const std::filesystem::path& path) {
    RenderOptions options = small_options(View::map);
    change(options);
    try {
      render(surface_of(grid, unit), options, path);
    } catch (const RenderError& error) {
      return std::string("render: ") + error.what();
    } catch (const WriteError& error) {
      return std::string("write: ") + error.what();
    }
    return std::string("none");
  };
  const auto picture = scratch / "a.png";
  const auto refused = [&](auto change, const std::string& why) {
    const std::string text = message(change, picture);
    EXPECT_EQ(text.rfind("render: ", 0), 0u) << text;
    EXPECT_NE(text.find(why), std::string::npos) << text;
    EXPECT_FALSE(std::filesystem::exists(picture));
  };
  refused([](auto& o) { o.appearance.colormap = "rainbow"; }, "viridis");
  refused([](auto& o) { o.width = 15; }, "15");
  refused([](auto& o) { o.height = 8193; }, "8193");
  refused([](auto& o) { o.lights[0].elevation = 91; }, "light");
  refused([](auto& o) { o.lights[0].azimuth = missing; }, "light");
  refused([](auto& o) { o.exaggeration = -1; }, "exaggeration");
  refused([](auto& o) { o.appearance.range = {{2, 2}}; }, "range");
  refused([](auto& o) { o.appearance.texture = Texture{}; }, "no pixels");
  refused([](auto& o) { o.appearance.texture = Texture{{2, 2, {Rgb{}}}}; }, "pixels");
  refused([](auto& o) { o.appearance.palette = Palette{}; }, "layer");
  refused([](auto& o) { o.material.ambient = 1.5; }, "ambient");
  refused([](auto& o) { o.pitch = 90; }, "camera");
  refused([](auto& o) { o.most_samples = 1; }, "samples");
  EXPECT_EQ(message([](auto&) {}, scratch / "none/a.png").rfind("write: ", 0), 0u);
  EXPECT_EQ(message([](auto&) {}, picture), "none");
}

}  // namespace
}  // namespace arete::vtk
