// SPDX-License-Identifier: MIT
#include "arete/field/boundary.h"

#include <gtest/gtest.h>

#include <vector>

namespace arete {
namespace {

double value_at(Boundary boundary, Index index, const std::vector<double>& p) {
  const Continuation c = continued(boundary, index, static_cast<Index>(p.size()));
  return p[static_cast<std::size_t>(c.near)] +
         static_cast<double>(c.steps) *
             (p[static_cast<std::size_t>(c.near)] - p[static_cast<std::size_t>(c.far)]);
}

TEST(boundary, continues_as_documented) {
  const std::vector<double> p{1, 4, 9, 16};
  const auto line = [&](Boundary b) {
    std::vector<double> values;
    for (Index i = -3; i <= 6; ++i) values.push_back(value_at(b, i, p));
    return values;
  };
  using V = std::vector<double>;
  EXPECT_EQ(line(Boundary::extrapolate), (V{-8, -5, -2, 1, 4, 9, 16, 23, 30, 37}));
  EXPECT_EQ(line(Boundary::clamp), (V{1, 1, 1, 1, 4, 9, 16, 16, 16, 16}));
  EXPECT_EQ(line(Boundary::reflect), (V{16, 9, 4, 1, 4, 9, 16, 9, 4, 1}));
  EXPECT_EQ(line(Boundary::periodic), (V{4, 9, 16, 1, 4, 9, 16, 1, 4, 9}));
}

TEST(boundary, far_indices_and_one_sample_stay_inside) {
  for (Boundary b : {Boundary::extrapolate, Boundary::clamp, Boundary::reflect, Boundary::periodic})
    for (Index n : {1, 2, 3, 7})
      for (Index i = -50; i <= 50; ++i) {
        const Continuation c = continued(b, i, n);
        EXPECT_TRUE(c.near >= 0 && c.near < n && c.far >= 0 && c.far < n);
        EXPECT_TRUE(n > 1 || c.steps == 0);
      }
}

TEST(boundary, names_round_trip_and_others_are_refused) {
  for (const char* name : {"extrapolate", "clamp", "reflect", "periodic", "none"})
    EXPECT_EQ(to_string(parse_boundary(name)), name);
  EXPECT_EQ(parse_boundaries("periodic,clamp"), (Boundaries{Boundary::periodic, Boundary::clamp}));
  EXPECT_EQ(parse_boundaries("reflect"), (Boundaries{Boundary::reflect, Boundary::reflect}));
  EXPECT_THROW((void)parse_boundaries("mirror"), InvalidField);
  EXPECT_THROW((void)parse_boundaries("clamp,"), InvalidField);
  EXPECT_THROW((void)parse_boundaries("clamp,clamp,clamp"), InvalidField);
}

}  // namespace
}  // namespace arete
