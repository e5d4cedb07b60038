// SPDX-License-Identifier: MIT
#include "arete/vtk/plot_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <set>

#include "arete/vtk/error.h"
#include "fixtures.h"
#include "pictures.h"

namespace arete::vtk {
namespace {

constexpr Rgb white{255, 255, 255};

class PlotCurve : public testing::Test {
 protected:
  void SetUp() override { unsetenv("DISPLAY"); }

  static Image draw(const Polyline& curve, const std::optional<Polyline>& control,
                    const PlotOptions& options) {
    const Scratch scratch;
    plot_curve(curve, control, options, scratch / "a.png");
    return read_png(scratch / "a.png");
  }
};

PlotOptions small_options() {
  PlotOptions options;
  options.width = 240;
  options.height = 120;
  return options;
}

bool is_drawn(const Rgb& pixel) { return pixel != white; }

Grid<double> circle() {
  Grid<double> points({90, 2});
  for (Index k = 0; k < 90; ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / 90;
    points(k, 0) = 1000 + 3 * std::cos(angle);
    points(k, 1) = 3 * std::sin(angle);
  }
  return points;
}

Grid<double> corner() {
  Grid<double> points({3, 2});  // (0, 0), (2, 0), (2, 1)
  points(1, 0) = points(2, 0) = 2;
  points(2, 1) = 1;
  return points;
}

TEST_F(PlotCurve, a_circle_is_round_and_fills_the_height_between_margins) {
  const auto points = circle();
  const Image image = draw({std::as_const(points).view(), true}, {}, small_options());
  ASSERT_EQ(image.width, 240);
  ASSERT_EQ(image.height, 120);
  const Box box = box_of(image, is_drawn);
  EXPECT_NEAR(box.width(), box.height(), 1);
  EXPECT_NEAR(box.height(), 100 + 2.5, 2);  // margins of a twelfth, and the line's width
  EXPECT_NEAR(box.x0 + box.x1, 239, 2) << "in the middle";
  EXPECT_NEAR(box.y0 + box.y1, 119, 2);
}

TEST_F(PlotCurve, unequal_axes_fill_the_width_too) {
  const auto points = circle();
  PlotOptions options = small_options();
  options.equal_axes = false;
  const Box box = box_of(draw({std::as_const(points).view(), true}, {}, options), is_drawn);
  EXPECT_NEAR(box.width(), 220 + 2.5, 2);
  EXPECT_NEAR(box.height(), 100 + 2.5, 2);
}

TEST_F(PlotCurve, y_grows_upwards_and_x_to_the_right) {
  const auto points = corner();
  const Image image = draw({std::as_const(points).view()}, {}, small_options());
  // 2 x 1 in 220 x 100: the corner (2, 0) is at (220, 110), (2, 1) at (220, 10), (0, 0) at (20,
  // 110).
  EXPECT_TRUE(is_drawn(image(120, 109)));
  EXPECT_TRUE(is_drawn(image(219, 60)));
  EXPECT_FALSE(is_drawn(image(21, 60)));
  EXPECT_FALSE(is_drawn(image(120, 11)));
}

TEST_F(PlotCurve, a_closed_curve_has_one_side_more) {
  const auto points = corner();
  const auto middle_of_the_last_side = [&](bool closed) {
    const Image image = draw({std::as_const(points).view(), closed}, {}, small_options());
    return is_drawn(image(120, 60));
  };
  EXPECT_TRUE(middle_of_the_last_side(true));
  EXPECT_FALSE(middle_of_the_last_side(false));
}

TEST_F(PlotCurve, control_points_lie_over_the_curve_and_that_over_the_polygon) {
  const auto points = corner();
  const Polyline line{std::as_const(points).view()};
  const PlotOptions options = small_options();
  const Image image = draw(line, line, options);
  EXPECT_EQ(image(20, 110), options.point_color);
  EXPECT_EQ(image(220, 110), options.point_color);
  EXPECT_EQ(image(220, 10), options.point_color);
  int curve = 0;
  for (int y = 105; y < 115; ++y) curve += image(120, y) == options.curve_color ? 1 : 0;
  EXPECT_GE(curve, 2);
  for (int y = 0; y < 120; ++y) EXPECT_NE(image(120, y), options.control_color);
}

TEST_F(PlotCurve, the_control_polygon_counts_for_the_frame) {
  const auto inner = circle();
  Grid<double> outer({4, 2});
  for (Index k = 0; k < 4; ++k) {
    outer(k, 0) = 1000 + (k == 1 || k == 2 ? 6 : -6);
    outer(k, 1) = k < 2 ? -6 : 6;
  }
  const Image image = draw({std::as_const(inner).view(), true},
                           Polyline{std::as_const(outer).view(), true}, small_options());
  const Box curve = box_of(image, [](const Rgb& p) { return p == PlotOptions{}.curve_color; });
  EXPECT_NEAR(curve.height(), 50, 3) << "half as large as the polygon";
  EXPECT_EQ(image(70, 60)[0], image(70, 60)[2]) << "the closing side is there, in gray";
  EXPECT_TRUE(is_drawn(image(70, 60)) || is_drawn(image(69, 60)));
}

TEST_F(PlotCurve, edges_are_smooth) {
  const auto points = circle();
  std::set<Rgb> shades;
  for (const Rgb& pixel : draw({std::as_const(points).view(), true}, {}, small_options()).pixels) {
    shades.insert(pixel);
  }
  EXPECT_GE(shades.size(), 10u) << "4 x 4 samples a pixel give up to 15 shades between";
}

TEST_F(PlotCurve, a_straight_line_along_an_axis_is_ordinary) {
  Grid<double> points({2, 3}, 1);  // of three coordinates the first two
  points(1, 0) = 5;
  const Box box = box_of(draw({std::as_const(points).view()}, {}, small_options()), is_drawn);
  EXPECT_NEAR(box.width(), 222, 2);
  EXPECT_NEAR(box.height(), 3, 1);
  const Grid<double> same({2, 2}, 7);
  EXPECT_LE(box_of(draw({same.view()}, {}, small_options()), is_drawn).width(), 4);
}

TEST_F(PlotCurve, refuses_what_is_no_curve_or_no_picture) {
  const Scratch scratch;
  const Grid<double> one({1, 2}, 0);
  const Grid<double> two({2, 2}, 0);
  const auto path = scratch / "a.png";
  EXPECT_THROW(plot_curve({one.view()}, {}, {}, path), InvalidField);
  EXPECT_THROW(plot_curve({two.view()}, Polyline{one.view()}, {}, path), InvalidField);
  PlotOptions options = small_options();
  options.width = 0;
  EXPECT_THROW(plot_curve({two.view()}, {}, options, path), RenderError);
  options = small_options();
  options.line_width = 0;
  EXPECT_THROW(plot_curve({two.view()}, {}, options, path), RenderError);
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_THROW(plot_curve({two.view()}, {}, small_options(), scratch / "none/a.png"), WriteError);
}

}  // namespace
}  // namespace arete::vtk
