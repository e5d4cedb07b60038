// SPDX-License-Identifier: MIT
#include "arete/refine/axis_plan.h"

#include <gtest/gtest.h>

#include "arete/scheme/catalogue.h"

namespace arete {
namespace {

AxisPlan plan(const char* scheme, Index count, int levels, Alignment alignment,
              Boundary boundary = Boundary::extrapolate) {
  return {parse_scheme(scheme).mask(), count, {levels, boundary, alignment, {}, {}}};
}

TEST(axis_plan, nodes_of_a_primal_scheme_keep_both_ends) {
  for (const char* scheme : {"four-point", "b-spline", "gentle", "ternary-four-point"}) {
    const AxisPlan p = plan(scheme, 403, 3, Alignment::nodes);
    const Index scale = parse_scheme(scheme).mask().arity() == 2 ? 8 : 27;
    EXPECT_EQ(p.output_count(), scale * 402 + 1);
    EXPECT_EQ(p.first_position(), 0);
    EXPECT_EQ(p.spacing(), Rational(1, scale));
  }
}

TEST(axis_plan, nodes_of_dual_and_asymmetric_schemes_lie_where_tau_puts_them_and_inside) {
  // Chaikin on -2..1: tau = -1/2, so level 1 lies at (i + 1/2)/2: 1/4, 3/4, ...
  const AxisPlan chaikin = plan("chaikin", 5, 1, Alignment::nodes);
  EXPECT_EQ(chaikin.first_position(), Rational(1, 4));
  EXPECT_EQ(chaikin.output_count(), 8);
  // The same samples from the other numbering.
  const AxisPlan spline = plan("b-spline:degree=2", 5, 1, Alignment::nodes);
  EXPECT_EQ(spline.first_position(), Rational(1, 4));
  EXPECT_EQ(spline.output_count(), 8);
  for (const char* scheme : {"four-parameter:lambda=3/32,mu=1/32,nu=1/4,omega=1/32", "three-point",
                             "ternary-two-step", "corner-cutting:u=1/5,v=3/10"}) {
    for (int levels : {1, 2, 5}) {
      const AxisPlan p = plan(scheme, 7, levels, Alignment::nodes);
      const Rational last = p.first_position() + (p.output_count() - 1) * p.spacing();
      EXPECT_GE(p.first_position(), 0);
      EXPECT_LT(p.first_position(), p.spacing());
      EXPECT_LE(last, 6);
      EXPECT_GT(last, 6 - p.spacing());
    }
  }
}

TEST(axis_plan, cells_tile_the_same_box_for_primal_dual_and_ternary_schemes) {
  for (const char* scheme :
       {"four-point", "b-spline", "chaikin", "b-spline:degree=2", "three-point",
        "ternary-four-point", "ternary-two-step", "ternary-two-step-9"}) {
    for (int levels : {0, 1, 2, 3}) {
      const AxisPlan p = plan(scheme, 6, levels, Alignment::cells);
      Index scale = 1;
      for (int l = 0; l < levels; ++l) scale *= parse_scheme(scheme).mask().arity();
      EXPECT_EQ(p.misplacement(), 0) << scheme << levels;
      EXPECT_EQ(p.output_count(), 6 * scale) << scheme << levels;
      EXPECT_EQ(p.first_position(), Rational(1, 2 * scale) - Rational(1, 2)) << scheme << levels;
    }
  }
}

TEST(axis_plan, cells_of_any_other_shift_stay_on_their_lattice_and_say_how_far_off) {
  const AxisPlan p =
      plan("four-parameter:lambda=3/32,mu=1/32,nu=1/4,omega=1/32", 6, 1, Alignment::cells);
  EXPECT_EQ(p.output_count(), 12);
  EXPECT_NE(p.misplacement(), 0);
  EXPECT_LE(abs(p.misplacement()), Rational(1, 4));
  // tau = 1/8: the lattice of level 1 is (i - 1/8)/2; its true position is kept.
  EXPECT_EQ(p.first_position(), Rational(-1, 4) + p.misplacement());
  EXPECT_TRUE(is_integer(Rational(p.first_position() * 2 + Rational(1, 8))));
}

TEST(axis_plan, closed_axes_give_one_turn) {
  EXPECT_EQ(plan("chaikin", 5, 3, Alignment::nodes, Boundary::periodic).output_count(), 40);
  EXPECT_EQ(plan("four-point", 1, 2, Alignment::nodes, Boundary::periodic).output_count(), 4);
}

TEST(axis_plan, impossible_requests_are_refused) {
  EXPECT_THROW(plan("four-point", 0, 1, Alignment::nodes), InvalidField);
  EXPECT_THROW(plan("four-point", 5, -1, Alignment::nodes), InvalidField);
  EXPECT_THROW(plan("four-point", 5, 60, Alignment::nodes), InvalidField);
  EXPECT_THROW(plan("four-point", 2, 1, Alignment::nodes, Boundary::none), InvalidField);
  EXPECT_THROW(plan("ternary-two-step-9", 5, 100000, Alignment::cells), InvalidField);
}

}  // namespace
}  // namespace arete
