// SPDX-License-Identifier: MIT
// Catmull-Clark by OpenSubdiv against the tensor-product cubic B-spline of the grid engine. Heights
// are dyadic, so that no sum rounds and the order of summation cannot matter: equal means equal.
#include <gtest/gtest.h>

#include <cmath>

#include "arete/opensubdiv/catmull_clark.h"
#include "arete/refine/free_corners.h"
#include "arete/refine/refiner.h"
#include "support/fields.h"
#include "support/schemes.h"

namespace arete {
namespace {

using opensubdiv::catmull_clark;
using opensubdiv::CornerRule;

constexpr Extent sizes[]{{2, 2}, {3, 5}, {2, 7}, {17, 9}, {33, 33}};

Grid<double> by_engine(const Grid<double>& heights, const char* scheme, int levels) {
  RefineOptions options;
  options.levels = levels;
  options.boundaries = {Boundary::extrapolate, Boundary::extrapolate};
  return refine(heights, parse_scheme(scheme), options);
}

// Number of samples that differ at all; a NaN differs from everything.
int differences(const Grid<double>& a, const Grid<double>& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.samples().size(); ++i)
    if (!(a.samples()[i] == b.samples()[i])) ++count;
  return count;
}

TEST(opensubdiv, cubic_b_spline_is_catmull_clark_with_sharp_corners_on_the_whole_grid) {
  for (const char* scheme : {"b-spline:degree=3", "four-parameter:lambda=1/8,mu=1/8,omega=0"}) {
    for (Extent extent : sizes) {
      const Grid<double> heights = test::dyadic_heights(extent, 3);
      for (int level = 1; level <= 3; ++level) {
        const Grid<double> ours = by_engine(heights, scheme, level);
        const Grid<double> theirs = catmull_clark(heights, level, CornerRule::sharp);
        ASSERT_EQ(ours.extent(), theirs.extent());
        EXPECT_EQ(differences(ours, theirs), 0)
            << scheme << " " << extent.rows << " x " << extent.cols << ", level " << level;
      }
    }
  }
}

// With EDGE_ONLY the corner vertex is a smooth vertex of the closed rim curve, p' = (6 p + a + b)/8
// with its rim neighbours a and b, where the extrapolated tensor product keeps p. New samples of
// later levels that read the corner inherit the difference: those within 2 input samples of it
// along both axes.
TEST(opensubdiv, smooth_corners_change_nothing_but_the_corners) {
  for (Extent extent : {Extent{9, 6}, Extent{17, 9}, Extent{33, 33}}) {
    const Grid<double> heights = test::dyadic_heights(extent, 5);
    for (int level = 1; level <= 3; ++level) {
      const Grid<double> ours = by_engine(heights, "b-spline:degree=3", level);
      const Grid<double> theirs = catmull_clark(heights, level, CornerRule::smooth);
      ASSERT_EQ(ours.extent(), theirs.extent());
      const Index near = Index{2} << level;
      int at_corners = 0;
      for (Index r = 0; r < ours.rows(); ++r) {
        for (Index c = 0; c < ours.cols(); ++c) {
          if (ours(r, c) == theirs(r, c)) continue;
          const bool corner =
              std::min(r, ours.rows() - 1 - r) < near && std::min(c, ours.cols() - 1 - c) < near;
          EXPECT_TRUE(corner) << r << ", " << c << " at level " << level;
          ++at_corners;
        }
      }
      EXPECT_GE(at_corners, 4) << "the two rules must differ at every corner";
      if (level == 1) {
        EXPECT_EQ(at_corners, 4);
        EXPECT_EQ(theirs(0, 0), (6 * heights(0, 0) + heights(0, 1) + heights(1, 0)) / 8);
      }
    }
  }
}

TEST(opensubdiv, free_corners_are_smooth_corners_on_the_whole_grid) {
  for (Extent extent : sizes) {
    const Grid<double> heights = test::dyadic_heights(extent, 12);
    for (int level = 0; level <= 3; ++level) {
      const Grid<double> ours = refine_free_corners(heights, level);
      const Grid<double> theirs = catmull_clark(heights, level, CornerRule::smooth);
      ASSERT_EQ(ours.extent(), theirs.extent());
      EXPECT_EQ(differences(ours, theirs), 0)
          << extent.rows << " x " << extent.cols << ", level " << level;
    }
  }
}

TEST(opensubdiv, no_other_scheme_passes_for_catmull_clark) {
  const Grid<double> heights = test::dyadic_heights({9, 9}, 9);
  const Grid<double> theirs = catmull_clark(heights, 2, CornerRule::sharp);
  for (const char* scheme : {"gentle", "four-point", "b-spline:degree=5",
                             "four-parameter:lambda=126/1000,mu=1/8,omega=0"})
    EXPECT_GT(differences(by_engine(heights, scheme, 2), theirs), 100) << scheme;
}

TEST(opensubdiv, every_sample_of_every_plane_lands_in_its_place) {
  // Planes are reproduced exactly, so the coordinates say where each vertex belongs.
  const Grid<double> rows = test::plane<double>({5, 4}, 0, 1, 0);
  const Grid<double> cols = test::plane<double>({5, 4}, 0, 0, 1);
  const auto fine = catmull_clark({rows.view(), cols.view()}, 3, CornerRule::sharp);
  ASSERT_EQ(fine.front().extent(), (Extent{33, 25}));
  for (Index r = 0; r < 33; ++r) {
    for (Index c = 0; c < 25; ++c) {
      EXPECT_EQ(fine[0](r, c), static_cast<double>(r) / 8);
      EXPECT_EQ(fine[1](r, c), static_cast<double>(c) / 8);
    }
  }
}

TEST(opensubdiv, level_zero_is_the_input) {
  const Grid<double> heights = test::random_heights({4, 3});
  EXPECT_EQ(catmull_clark(heights, 0, CornerRule::sharp).samples(), heights.samples());
}

TEST(opensubdiv, what_is_no_quad_grid_is_refused) {
  EXPECT_THROW((void)catmull_clark(Grid<double>({1, 9}), 1, CornerRule::sharp), InvalidField);
  EXPECT_THROW((void)catmull_clark(Grid<double>({4, 4}), 11, CornerRule::sharp), InvalidField);
  // Refused by its size, before a sample is read.
  const double sample = 0;
  const std::vector<GridView<const double>> vast{{&sample, {30000, 30000}, 0}};
  EXPECT_THROW((void)catmull_clark(vast, 1, CornerRule::sharp), InvalidField);
  EXPECT_THROW((void)catmull_clark(std::vector<GridView<const double>>{}, 1, CornerRule::sharp),
               InvalidField);
}

}  // namespace
}  // namespace arete
