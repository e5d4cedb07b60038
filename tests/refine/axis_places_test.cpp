// SPDX-License-Identifier: MIT
#include "arete/refine/axis_places.h"

#include <gtest/gtest.h>

#include "support/schemes.h"

namespace arete {
namespace {

// cell + t is the position that the plan states; where t is outside 0..1, cell is an end cell.
TEST(axis_places, say_where_the_plan_says_for_every_scheme_and_boundary) {
  for (const Scheme& scheme : test::sample_schemes()) {
    for (Boundary boundary : {Boundary::extrapolate, Boundary::periodic}) {
      for (Alignment alignment : {Alignment::nodes, Alignment::cells}) {
        const AxisPlan plan(scheme.mask(), 7, {2, boundary, alignment, {}, {}});
        const auto places = sample_places(plan, {0, plan.output_count() - 1});
        ASSERT_EQ(static_cast<Index>(places.size()), plan.output_count());
        for (Index i = 0; i < plan.output_count(); ++i) {
          const AxisPlace& place = places[static_cast<std::size_t>(i)];
          double position = to_double(plan.first_position() + i * plan.spacing());
          if (boundary == Boundary::periodic) {
            if (position < 0) position += 7;
            if (position >= 7) position -= 7;
            EXPECT_GE(place.t, 0);
            EXPECT_LT(place.t, 1);
          } else {
            EXPECT_TRUE(place.t >= 0 || place.cell == 0);
            EXPECT_TRUE(place.t < 1 || place.cell == 5);
          }
          EXPECT_NEAR(static_cast<double>(place.cell) + place.t, position, 1e-12) << scheme.text();
        }
      }
    }
  }
}

TEST(axis_places, middles_have_the_cell_around_them_as_parent) {
  const AxisPlan plan(parse_scheme("four-point").mask(), 4, {2, {}, {}, {}, {}});
  const auto middles = middle_places(plan, {0, plan.output_count() - 2});
  ASSERT_EQ(middles.size(), 12u);
  for (std::size_t i = 0; i < middles.size(); ++i) {
    EXPECT_EQ(middles[i].cell, static_cast<Index>(i) / 4);
    EXPECT_EQ(middles[i].t, (static_cast<double>(i % 4) + 0.5) / 4);
  }
  const auto later = middle_places(plan, {5, 6});
  EXPECT_EQ(later[0].cell, middles[5].cell);
  EXPECT_EQ(later[1].t, middles[6].t);
}

TEST(axis_places, one_sample_is_one_place) {
  const AxisPlan plan(parse_scheme("gentle").mask(), 1, {3, {}, {}, {}, {}});
  const auto places = sample_places(plan, {0, 0});
  ASSERT_EQ(places.size(), 1u);
  EXPECT_EQ(places.front().cell, 0);
  EXPECT_EQ(places.front().t, 0);
}

}  // namespace
}  // namespace arete
