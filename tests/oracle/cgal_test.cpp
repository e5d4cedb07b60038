// SPDX-License-Identifier: MIT
// CGAL's Catmull-Clark, OpenSubdiv's with VTX_BOUNDARY_EDGE_ONLY, and the grid engine: three
// programs that know nothing of each other.
#include <gtest/gtest.h>

#include <cmath>

#include "arete/cgal/catmull_clark.h"
#include "arete/opensubdiv/catmull_clark.h"
#include "arete/refine/free_corners.h"
#include "arete/refine/refiner.h"
#include "support/fields.h"
#include "support/schemes.h"

namespace arete {
namespace {

TEST(cgal, catmull_clark_is_that_of_opensubdiv_with_smooth_corners) {
  for (Extent extent : {Extent{2, 2}, Extent{3, 5}, Extent{17, 9}, Extent{33, 33}}) {
    // In 0..1, so that the difference is relative to the relief.
    Grid<double> heights = test::random_heights(extent);
    for (double& h : heights.samples()) h = (h + 100) / 1000;
    for (int level = 1; level <= 3; ++level) {
      const Grid<double> a = cgal::catmull_clark(heights, level);
      const Grid<double> b =
          opensubdiv::catmull_clark(heights, level, opensubdiv::CornerRule::smooth);
      ASSERT_EQ(a.extent(), b.extent());
      double difference = 0;
      for (std::size_t i = 0; i < a.samples().size(); ++i)
        difference = std::max(difference, std::abs(a.samples()[i] - b.samples()[i]));
      EXPECT_LE(difference, 1e-14) << extent.rows << " x " << extent.cols << ", level " << level;
    }
  }
}

TEST(cgal, is_the_grid_with_free_corners_everywhere) {
  Grid<double> heights = test::random_heights({14, 9});
  for (double& h : heights.samples()) h = (h + 100) / 1000;
  for (int level = 1; level <= 3; ++level) {
    const Grid<double> ours = refine_free_corners(heights, level);
    const Grid<double> theirs = cgal::catmull_clark(heights, level);
    ASSERT_EQ(ours.extent(), theirs.extent());
    for (std::size_t i = 0; i < ours.samples().size(); ++i)
      ASSERT_NEAR(ours.samples()[i], theirs.samples()[i], 1e-14) << level;
  }
}

TEST(cgal, differs_from_the_extrapolated_grid_only_at_the_corners) {
  const Grid<double> heights = test::dyadic_heights({12, 9});
  for (int level = 1; level <= 3; ++level) {
    RefineOptions options;
    options.levels = level;
    const Grid<double> ours = refine(heights, parse_scheme("b-spline:degree=3"), options);
    const Grid<double> theirs = cgal::catmull_clark(heights, level);
    ASSERT_EQ(ours.extent(), theirs.extent());
    const Index near = Index{2} << level;
    double at_corners = 0;
    for (Index r = 0; r < ours.rows(); ++r) {
      for (Index c = 0; c < ours.cols(); ++c) {
        const double difference = std::abs(ours(r, c) - theirs(r, c));
        const bool corner =
            std::min(r, ours.rows() - 1 - r) < near && std::min(c, ours.cols() - 1 - c) < near;
        if (corner)
          at_corners = std::max(at_corners, difference);
        else
          EXPECT_LE(difference, 1e-12) << r << ", " << c;
      }
    }
    EXPECT_GT(at_corners, 1);
  }
}

TEST(cgal, what_is_no_quad_grid_is_refused) {
  EXPECT_THROW((void)cgal::catmull_clark(Grid<double>({1, 5}), 1), InvalidField);
  EXPECT_THROW((void)cgal::catmull_clark(Grid<double>({3, 5}), -1), InvalidField);
}

}  // namespace
}  // namespace arete
