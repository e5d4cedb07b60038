// SPDX-License-Identifier: GPL-3.0-or-later
#include "arete/meshlab/axis_samples.h"

#include <gtest/gtest.h>

#include <set>

#include "support/schemes.h"

namespace arete::meshlab {
namespace {

AxisSamples axis(const Scheme& scheme, Index count, int levels, Boundary boundary, bool wraps) {
  AxisOptions options;
  options.levels = levels;
  options.boundary = boundary;
  return {AxisPlan(scheme.mask(), count, options), wraps};
}

void expect_laws(const AxisSamples& a, Index count, bool wraps, const std::string& where) {
  std::set<Index> used;
  for (Index successor : a.successors()) {
    if (successor < 0) continue;
    EXPECT_LT(successor, static_cast<Index>(a.samples().size())) << where;
    EXPECT_TRUE(used.insert(successor).second) << where << ": two old vertices become one";
  }
  EXPECT_EQ(a.cells().size(), a.samples().size() - (wraps ? 0 : 1)) << where;
  for (const AxisSample& s : a.samples()) {
    EXPECT_GE(s.cell, 0) << where;
    EXPECT_LT(s.cell, wraps ? count : count - 1) << where;
    EXPECT_GE(s.t, 0) << where;
    EXPECT_LE(s.t, 1) << where;
  }
  for (const AxisCell& c : a.cells()) {
    EXPECT_GE((c.begin + c.end) / 2, 0) << where;
    EXPECT_LE((c.begin + c.end) / 2, 1) << where;
  }
}

TEST(axis_samples, laws_for_every_scheme_boundary_and_level) {
  for (const Scheme& scheme : arete::test::sample_schemes()) {
    for (int levels : {1, 2}) {
      for (Index count : {2, 3, 7}) {
        const std::string where = scheme.text() + " x" + std::to_string(levels);
        for (Boundary boundary : {Boundary::extrapolate, Boundary::clamp, Boundary::reflect}) {
          const AxisSamples a = axis(scheme, count, levels, boundary, false);
          expect_laws(a, count, false, where);
          for (Index successor : a.successors()) EXPECT_GE(successor, 0) << where;
        }
        expect_laws(axis(scheme, count, levels, Boundary::periodic, false), count, false, where);
        if (count < 3) continue;
        const AxisSamples closed = axis(scheme, count, levels, Boundary::periodic, true);
        expect_laws(closed, count, true, where);
        for (Index successor : closed.successors()) EXPECT_GE(successor, 0) << where;
      }
    }
  }
}

TEST(axis_samples, interpolating_schemes_keep_old_samples_in_place) {
  const AxisSamples a = axis(make_scheme("four-point"), 5, 2, Boundary::extrapolate, false);
  ASSERT_EQ(a.samples().size(), 17u);
  EXPECT_EQ(a.successors(), (std::vector<Index>{0, 4, 8, 12, 16}));
}

TEST(axis_samples, of_two_new_samples_at_the_same_distance_the_earlier_one_takes_over) {
  const AxisSamples a = axis(make_scheme("chaikin"), 4, 1, Boundary::extrapolate, false);
  ASSERT_EQ(a.samples().size(), 6u);  // at 1/4, 3/4, 5/4, ...
  EXPECT_EQ(a.successors(), (std::vector<Index>{0, 1, 3, 5}));
}

TEST(axis_samples, without_ghosts_the_rim_has_no_successor) {
  const AxisSamples a = axis(make_scheme("four-point"), 7, 1, Boundary::none, false);
  ASSERT_EQ(a.samples().size(), 9u);  // N -> 2N - 5
  EXPECT_EQ(a.successors(), (std::vector<Index>{-1, 0, 2, 4, 6, 8, -1}));
}

TEST(axis_samples, too_small_an_axis_is_refused_with_a_remedy) {
  try {
    (void)axis(make_scheme("four-point"), 4, 2, Boundary::none, false);
    FAIL();
  } catch (const InvalidField& error) {
    EXPECT_NE(std::string(error.what()).find("none"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace arete::meshlab
