// SPDX-License-Identifier: MIT
#include "arete/fit/parameter_space.h"

#include <gtest/gtest.h>

#include "arete/analysis/polynomial.h"
#include "arete/scheme/catalogue.h"

namespace arete {
namespace {

TEST(parameter_space, every_member_keeps_tau_and_the_sum_rules_of_the_start) {
  for (const char* text :
       {"four-parameter", "four-parameter:lambda=1/8,mu=1/8,omega=1/32", "four-point",
        "four-parameter-c2", "three-parameter", "ternary-four-point", "ternary-two-step",
        "difference:a0=1/10,a1=0,a2=3/20,a3=1/4,m=1",
        "mask:arity=2,first=-3,coefficients=-1/16;0;9/16;1;9/16;0;-1/16"}) {
    const Scheme start = parse_scheme(text);
    const ParameterSpace space(start, {});
    const int rules = std::min(2, sum_rules(start.mask()));
    for (int i = 0; i < space.dimension(); ++i) {
      std::vector<double> u(static_cast<std::size_t>(space.dimension()), 0.0);
      EXPECT_EQ(space.at(u), start);
      u[static_cast<std::size_t>(i)] = 0.0123456789;
      const Scheme moved = space.at(u);
      EXPECT_FALSE(moved == start) << text;
      EXPECT_EQ(moved.mask().tau(), start.mask().tau()) << text << " -> " << moved.text();
      EXPECT_GE(sum_rules(moved.mask()), rules) << text << " -> " << moved.text();
    }
  }
}

TEST(parameter_space, frees_what_is_linear_and_holds_the_rest) {
  const auto dimension = [](const char* text, std::vector<std::string> names = {}) {
    return ParameterSpace(parse_scheme(text), names).dimension();
  };
  // lambda, mu and omega move, nu is held; lambda = mu keeps the samples in place.
  EXPECT_EQ(dimension("four-parameter"), 2);
  EXPECT_EQ(ParameterSpace(parse_scheme("four-parameter"), {}).free_names(),
            (std::vector<std::string>{"lambda", "mu", "omega"}));
  EXPECT_EQ(dimension("four-parameter", {"omega"}), 1);
  EXPECT_EQ(dimension("four-point"), 1);
  EXPECT_EQ(dimension("four-parameter-c2"), 1);
  // Seven coefficients, two phases, two sum rules: 7 - 2 - 2.
  EXPECT_EQ(dimension("mask:arity=2,first=-3,coefficients=-1/16;0;9/16;1;9/16;0;-1/16"), 3);
}

TEST(parameter_space, what_cannot_move_is_refused) {
  EXPECT_THROW(ParameterSpace(parse_scheme("gentle"), {}), InvalidScheme);
  // Chaikin is the only corner cutting that keeps planes; of ternary-two-step-9 the mask is
  // quadratic in b; the parameter of the last moves the samples.
  EXPECT_THROW(ParameterSpace(parse_scheme("corner-cutting"), {}), InvalidScheme);
  EXPECT_THROW(ParameterSpace(parse_scheme("ternary-two-step-9"), {}), InvalidScheme);
  EXPECT_THROW(ParameterSpace(parse_scheme("two-parameter:a=1/8"), {}), InvalidScheme);
  EXPECT_THROW(ParameterSpace(parse_scheme("b-spline"), {}), InvalidScheme);
  EXPECT_THROW(ParameterSpace(parse_scheme("b-spline"), {"degree"}), InvalidScheme);
  EXPECT_THROW(ParameterSpace(parse_scheme("four-point"), {"lambda"}), InvalidScheme);
  EXPECT_THROW(ParameterSpace(parse_scheme("four-parameter"), {"nu", "omega"}), InvalidScheme);
  // nu alone would move the samples.
  EXPECT_THROW(ParameterSpace(parse_scheme("four-parameter"), {"nu"}), InvalidScheme);
}

}  // namespace
}  // namespace arete
