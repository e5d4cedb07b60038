// SPDX-License-Identifier: MIT
#include "arete/vtk/plot_functions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "arete/vtk/error.h"
#include "pictures.h"
#include "support/temporary_folder.h"

namespace arete::vtk {
namespace {

FunctionGraph graph(const char* label, double (*f)(double)) {
  FunctionGraph result{label, Grid<double>({101, 2})};
  for (Index i = 0; i <= 100; ++i) {
    result.points(i, 0) = static_cast<double>(i) / 100;
    result.points(i, 1) = f(result.points(i, 0));
  }
  return result;
}

bool is_blue(const Rgb& pixel) { return pixel[2] > pixel[0] + 60; }

// The mean row of blue pixels in a column, among the rows first..last; -1 if there are none.
double line_at(const Image& picture, int column, int first, int last) {
  double sum = 0;
  int count = 0;
  for (int row = first; row < last; ++row)
    if (is_blue(picture(column, row))) {
      sum += row;
      ++count;
    }
  return count == 0 ? -1 : sum / count;
}

TEST(plot_functions, graphs_stand_one_above_the_other_the_right_way_up) {
  const test::TemporaryFolder folder;
  plot_functions(
      {graph("rises", [](double x) { return x; }), graph("falls", [](double x) { return -3 * x; })},
      "x", {600, 500}, folder.file("f.png"));
  const Image picture = read_png(folder.file("f.png"));
  ASSERT_EQ(picture.width, 600);
  ASSERT_EQ(picture.height, 500);
  const double upper_left = line_at(picture, 150, 0, 220);
  const double upper_right = line_at(picture, 500, 0, 220);
  const double lower_left = line_at(picture, 150, 245, 450);
  const double lower_right = line_at(picture, 500, 245, 450);
  ASSERT_GT(std::min({upper_left, upper_right, lower_left, lower_right}), 0);
  EXPECT_GT(upper_left, upper_right + 50);  // rows count downwards
  EXPECT_LT(lower_left, lower_right - 50);
  // Each has its own scale, so both fill their panels alike.
  EXPECT_NEAR(upper_left - upper_right, lower_right - lower_left, 6);
}

TEST(plot_functions, impossible_plots_are_refused) {
  const test::TemporaryFolder folder;
  const auto line = graph("f", [](double x) { return x; });
  const auto png = folder.file("f.png");
  EXPECT_THROW(plot_functions({}, "x", {600, 500}, png), InvalidField);
  EXPECT_THROW(plot_functions({line}, "x", {100, 500}, png), RenderError);
  EXPECT_THROW(plot_functions({line}, "x", {600, 5000}, png), RenderError);
  EXPECT_THROW(plot_functions(std::vector<FunctionGraph>(9, line), "x", {600, 500}, png),
               RenderError);
  auto wild = line;
  wild.points(3, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(plot_functions({wild}, "x", {600, 500}, png), InvalidField);
  wild.points = Grid<double>({1, 2});
  EXPECT_THROW(plot_functions({wild}, "x", {600, 500}, png), InvalidField);
  EXPECT_EQ(folder.entries(), 0);
}

TEST(plot_functions, a_constant_is_drawn) {
  const test::TemporaryFolder folder;
  plot_functions({graph("zero", [](double) { return 0.0; })}, "x", {400, 300},
                 folder.file("f.png"));
  const Image picture = read_png(folder.file("f.png"));
  EXPECT_GT(line_at(picture, 200, 0, 300), 0);
}

}  // namespace
}  // namespace arete::vtk
