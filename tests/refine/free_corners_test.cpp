// SPDX-License-Identifier: MIT
#include "arete/refine/free_corners.h"

#include <gtest/gtest.h>

#include "arete/refine/refiner.h"
#include "support/fields.h"
#include "support/schemes.h"

namespace arete {
namespace {

TEST(free_corners, the_corner_is_a_smooth_vertex_of_the_rim_and_nothing_else_changes_at_level_1) {
  const Grid<double> heights = test::dyadic_heights({5, 7});
  const Grid<double> held = refine(heights, parse_scheme("b-spline:degree=3"));
  const Grid<double> released = refine_free_corners(heights, 1);
  ASSERT_EQ(held.extent(), released.extent());
  for (Index r = 0; r < held.rows(); ++r) {
    for (Index c = 0; c < held.cols(); ++c) {
      const bool corner = r % (held.rows() - 1) == 0 && c % (held.cols() - 1) == 0;
      if (!corner) {
        EXPECT_EQ(held(r, c), released(r, c));
      }
    }
  }
  EXPECT_EQ(released(8, 12), (6 * heights(4, 6) + heights(4, 5) + heights(3, 6)) / 8);
}

TEST(free_corners, too_small_grids_and_negative_levels_are_refused) {
  EXPECT_THROW((void)refine_free_corners(Grid<double>({1, 4}), 1), InvalidField);
  EXPECT_THROW((void)refine_free_corners(Grid<double>({4, 4}), -1), InvalidField);
}

}  // namespace
}  // namespace arete
