// SPDX-License-Identifier: MIT
#include "arete/topology/height_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "support/fields.h"

namespace arete {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

template <class T = double>
Grid<T> hills(Extent extent) {
  Grid<T> grid(extent);
  for (Index r = 0; r < extent.rows; ++r)
    for (Index c = 0; c < extent.cols; ++c) {
      const double x = 0.05 * static_cast<double>(c);
      const double y = 0.04 * static_cast<double>(r);
      grid(r, c) = static_cast<T>(100 * std::sin(x) * std::cos(y) + 10 * std::sin(4 * x + 3 * y));
    }
  return grid;
}

struct Measured {
  double largest_error = 0;
  double area = 0;
  std::set<Index> held;  // samples within triangles
  bool turned_over = false;
};

// The plain way, by signs of areas in floating point over the box of every triangle.
template <class T>
Measured measure_plainly(const Grid<T>& z, const HeightTriangles& mesh) {
  Measured m;
  for (const auto& t : mesh.triangles) {
    double x[3];
    double y[3];
    double h[3];
    for (int k = 0; k < 3; ++k) {
      const Index s = mesh.samples.at(static_cast<std::size_t>(t[static_cast<std::size_t>(k)]));
      x[k] = static_cast<double>(s % z.cols());
      y[k] = static_cast<double>(s / z.cols());
      h[k] = z.samples()[static_cast<std::size_t>(s)];
    }
    const double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    m.turned_over = m.turned_over || !(area > 0);
    m.area += area / 2;
    for (double j = std::min({y[0], y[1], y[2]}); j <= std::max({y[0], y[1], y[2]}); ++j) {
      for (double i = std::min({x[0], x[1], x[2]}); i <= std::max({x[0], x[1], x[2]}); ++i) {
        const double u = ((i - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (j - y[0])) / area;
        const double v = ((x[1] - x[0]) * (j - y[0]) - (i - x[0]) * (y[1] - y[0])) / area;
        if (u < -1e-9 || v < -1e-9 || u + v > 1 + 1e-9) continue;
        const auto r = static_cast<Index>(j);
        const auto c = static_cast<Index>(i);
        m.held.insert(r * z.cols() + c);
        const double there = h[0] + u * (h[1] - h[0]) + v * (h[2] - h[0]);
        m.largest_error = std::max(m.largest_error, std::abs(there - z(r, c)));
      }
    }
  }
  return m;
}

// No edge has more than two triangles, and both run along it in opposite directions.
bool is_a_surface(const HeightTriangles& mesh) {
  std::set<std::pair<int, int>> edges;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      if (!edges.insert({t[k], t[(k + 1) % 3]}).second) return false;
  return true;
}

TEST(height_triangles, the_error_is_that_of_a_plain_measurement_and_the_plane_is_covered_once) {
  for (const auto& z : {hills({97, 129}), test::random_heights({41, 23}), hills({2, 40})}) {
    const Index all = (z.rows() - 1) * (z.cols() - 1);
    for (const Index most : {Index{2}, Index{3}, Index{7}, Index{50}, Index{999}, 2 * all}) {
      const auto mesh = triangulate_heights(z.view(), most);
      const Measured m = measure_plainly(z, mesh);
      EXPECT_LE(static_cast<Index>(mesh.triangles.size()), most);
      EXPECT_NEAR(mesh.largest_error, m.largest_error, 1e-9);
      EXPECT_EQ(m.area, static_cast<double>(all));
      EXPECT_EQ(m.held.size(), z.samples().size());
      EXPECT_FALSE(m.turned_over);
      EXPECT_TRUE(is_a_surface(mesh));
      EXPECT_EQ(mesh.left_out, 0);
    }
  }
}

TEST(height_triangles, the_budget_is_used_and_more_of_it_means_less_error) {
  const auto z = hills({97, 129});
  double before = std::numeric_limits<double>::infinity();
  for (const Index most : {100, 400, 1600, 6400, 2 * 96 * 128}) {
    const auto mesh = triangulate_heights(z.view(), most);
    EXPECT_LT(mesh.largest_error, before) << most;
    if (most < 2 * 96 * 128) {
      EXPECT_GE(static_cast<Index>(mesh.triangles.size()), most - 1) << "one may be left over";
    }
    before = mesh.largest_error;
  }
  EXPECT_LT(before, 1e-9) << "with all triangles nothing is lost";
}

TEST(height_triangles, a_plane_takes_two_triangles_and_a_roof_four) {
  EXPECT_EQ(
      triangulate_heights(test::plane({40, 70}, 3.0, 0.1, -0.7).view(), 1000).triangles.size(), 2u);
  EXPECT_EQ(triangulate_heights(test::plane<float>({40, 70}, 3.F, 0.1F, -0.7F).view(), 1000)
                .triangles.size(),
            2u)
      << "float's own steps are no relief";
  Grid<double> roof({5, 9});
  for (Index r = 0; r < 5; ++r)
    for (Index c = 0; c < 9; ++c) roof(r, c) = 10 - std::abs(static_cast<double>(c - 4));
  const auto mesh = triangulate_heights(roof.view(), 1000);
  EXPECT_EQ(mesh.triangles.size(), 4u);
  EXPECT_EQ(mesh.largest_error, 0);
  const Grid<double> cell({2, 2}, 1.0);
  EXPECT_EQ(triangulate_heights(cell.view(), 2).triangles.size(), 2u);
}

TEST(height_triangles, missing_samples_are_cut_out_and_no_others) {
  Grid<double> z = hills({60, 80});
  for (Index r = 0; r < 60; ++r)
    for (Index c = 0; c < 80; ++c) {
      const bool pond = (r - 20) * (r - 20) + (c - 30) * (c - 30) < 130;
      if (pond || c - r > 55 || (r > 40 && r < 50 && c > 50 && c < 70)) z(r, c) = nan;
    }
  std::set<Index> valid;
  for (std::size_t i = 0; i < z.samples().size(); ++i)
    if (std::isfinite(z.samples()[i])) valid.insert(static_cast<Index>(i));
  for (const Index most : {700, 2000, 20000}) {
    const auto mesh = triangulate_heights(z.view(), most);
    const Measured m = measure_plainly(z, mesh);
    EXPECT_LE(static_cast<Index>(mesh.triangles.size()), most);
    EXPECT_EQ(m.held, valid);
    EXPECT_EQ(mesh.left_out, 0);
    EXPECT_NEAR(mesh.largest_error, m.largest_error, 1e-9);
    EXPECT_FALSE(m.turned_over);
    EXPECT_TRUE(is_a_surface(mesh));
  }
  try {
    (void)triangulate_heights(z.view(), 20);
    FAIL();
  } catch (const InvalidField& error) {
    EXPECT_NE(std::string(error.what()).find("outline"), std::string::npos) << error.what();
  }
}

TEST(height_triangles, random_holes_leave_no_valid_sample_in_a_hole) {
  for (unsigned seed = 1; seed < 30; ++seed) {
    std::mt19937 random(seed);
    Grid<double> z = test::random_heights({12, 17}, seed);
    for (double& value : z.samples())
      if (random() % 5 < seed % 4) value = nan;
    const auto mesh = triangulate_heights(z.view(), 1000);
    const Measured m = measure_plainly(z, mesh);
    for (const Index s : m.held)
      EXPECT_TRUE(std::isfinite(z.samples()[static_cast<std::size_t>(s)]));
    Index valid = 0;
    for (const double value : z.samples()) valid += std::isfinite(value) ? 1 : 0;
    EXPECT_EQ(mesh.left_out, valid - static_cast<Index>(m.held.size()));
    for (Index r = 0; r + 1 < z.rows(); ++r)
      for (Index c = 0; c + 1 < z.cols(); ++c) {
        const Index at = r * z.cols() + c;
        const std::array<Index, 4> cell{at, at + 1, at + z.cols(), at + z.cols() + 1};
        if (!std::all_of(cell.begin(), cell.end(), [&](Index s) {
              return std::isfinite(z.samples()[static_cast<std::size_t>(s)]);
            }))
          continue;
        for (const Index s : cell) EXPECT_TRUE(m.held.count(s) == 1) << seed << ", sample " << s;
      }
    EXPECT_FALSE(m.turned_over);
    EXPECT_TRUE(is_a_surface(mesh));
  }
}

TEST(height_triangles, an_island_of_one_line_has_no_triangle) {
  Grid<double> z({9, 9}, nan);
  for (Index c = 0; c < 9; ++c) z(4, c) = 1;
  EXPECT_THROW((void)triangulate_heights(z.view(), 100), InvalidField);
  z(5, 3) = 1;
  const auto mesh = triangulate_heights(z.view(), 100);
  EXPECT_GE(mesh.triangles.size(), 1u);
  EXPECT_GE(mesh.left_out, 1);
}

TEST(height_triangles, refuses_what_has_no_triangles) {
  EXPECT_THROW((void)triangulate_heights(Grid<double>({1, 9}).view(), 10), InvalidField);
  EXPECT_THROW((void)triangulate_heights(Grid<double>({9, 1}).view(), 10), InvalidField);
  EXPECT_THROW((void)triangulate_heights(Grid<double>().view(), 10), InvalidField);
  EXPECT_THROW((void)triangulate_heights(Grid<double>({9, 9}).view(), 1), InvalidField);
  EXPECT_THROW((void)triangulate_heights(Grid<double>({9, 9}, nan).view(), 10), InvalidField);
}

}  // namespace
}  // namespace arete
