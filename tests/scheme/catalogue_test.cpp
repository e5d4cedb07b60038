// SPDX-License-Identifier: MIT
#include "arete/scheme/catalogue.h"

#include <gtest/gtest.h>

#include <set>

namespace arete {
namespace {

Mask mask_of(const char* text) { return parse_scheme(text).mask(); }

TEST(catalogue, holds_every_name_of_the_contract_once) {
  const std::set<std::string> contract{"four-parameter",
                                       "four-point",
                                       "four-parameter-c2",
                                       "gentle",
                                       "craggy",
                                       "two-parameter",
                                       "three-parameter",
                                       "difference",
                                       "three-point",
                                       "ternary-two-step",
                                       "ternary-two-step-9",
                                       "ternary-four-point",
                                       "corner-cutting",
                                       "chaikin",
                                       "de-rham",
                                       "b-spline",
                                       "dubuc-deslauriers",
                                       "mask"};
  std::set<std::string> names;
  for (const Family& family : catalogue()) EXPECT_TRUE(names.insert(family.name).second);
  EXPECT_EQ(names, contract);
}

TEST(catalogue, defaults_lie_in_the_accepted_and_the_usual_range) {
  for (const Family& family : catalogue())
    for (const Parameter& p : family.parameters) {
      EXPECT_LE(p.accepted.lowest, p.usual.lowest) << family.name << p.name;
      EXPECT_GE(p.accepted.highest, p.usual.highest) << family.name << p.name;
      if (p.fallback) {
        EXPECT_GE(*p.fallback, p.usual.lowest) << family.name << p.name;
        EXPECT_LE(*p.fallback, p.usual.highest) << family.name << p.name;
      }
      EXPECT_FALSE(p.meaning.empty());
    }
}

TEST(catalogue, text_form_round_trips_for_every_family) {
  for (const char* text : {"four-parameter:lambda=7/32,mu=7/32,nu=1/2,omega=3/64", "four-point",
                           "four-point:omega=0.07", "four-parameter-c2:nu=1/4", "gentle", "craggy",
                           "two-parameter:a=1/7,m=3,raise=0", "three-parameter:a=-1/48,c=-1/48",
                           "difference:a0=1/10,a1=0,a2=3/20,a3=1/4,m=1,raise=1", "three-point",
                           "ternary-two-step:b=-1/5", "ternary-two-step-9:b=1/6",
                           "ternary-four-point:mu=1/10", "corner-cutting:u=1/5,v=1/4", "chaikin",
                           "de-rham", "b-spline:degree=5", "dubuc-deslauriers:points=8",
                           "mask:arity=2,first=-3,coefficients=-1/16;0;9/16;1;9/16;0;-1/16"}) {
    const Scheme scheme = parse_scheme(text);
    EXPECT_EQ(parse_scheme(scheme.text()), scheme) << text;
  }
}

TEST(catalogue, members_that_are_the_same_scheme_have_the_same_mask) {
  const Mask cubic = mask_of("b-spline:degree=3");
  EXPECT_EQ(mask_of("four-parameter:lambda=1/8,mu=1/8,omega=0"), cubic);
  // Scheme (3) of its paper is numbered from -1.
  EXPECT_EQ(mask_of("two-parameter:a=1/4").symbol().shifted(-1), cubic.symbol());
  EXPECT_EQ(mask_of("four-parameter-c2:omega=0"), cubic);
  const Mask four_point = mask_of("four-point");
  EXPECT_EQ(mask_of("dubuc-deslauriers:points=4"), four_point);
  EXPECT_EQ(mask_of("three-parameter:a=-1/8,c=-1/8"), four_point);
  EXPECT_EQ(mask_of("mask:arity=2,first=-3,coefficients=-0.0625;0;0.5625;1;0.5625;0;-0.0625"),
            four_point);
  EXPECT_EQ(mask_of("gentle"), mask_of("four-parameter:lambda=7/32,mu=7/32,nu=1/2,omega=3/64"));
  EXPECT_EQ(mask_of("craggy"), mask_of("four-parameter:lambda=1/30,mu=1/30,nu=1/2,omega=1/3"));
  EXPECT_EQ(mask_of("corner-cutting"), mask_of("chaikin"));
  EXPECT_EQ(mask_of("corner-cutting:u=1/3,v=1/3"), mask_of("de-rham"));
  EXPECT_EQ(mask_of("three-point"), mask_of("two-parameter:a=-1/4"));
  // Chaikin and the quadratic B-spline differ by the numbering only.
  EXPECT_EQ(mask_of("chaikin").coefficients(), mask_of("b-spline:degree=2").coefficients());
  EXPECT_EQ(mask_of("chaikin").first(), -2);
  EXPECT_EQ(mask_of("b-spline:degree=2").first(), -1);
  // Two ternary steps, shifted by 2, are the 9-ary step.
  EXPECT_EQ(iterated(mask_of("ternary-two-step:b=1/7"), 2).symbol().shifted(-2),
            mask_of("ternary-two-step-9:b=1/7").symbol());
}

TEST(catalogue, printed_rules_stand_in_the_masks) {
  // four-parameter, generic: the even rule reads lambda, 1-lambda-mu, mu.
  const Mask m = mask_of("four-parameter:lambda=1/5,mu=1/10,nu=1/3,omega=1/7");
  EXPECT_EQ(m[2], Rational(1, 5));
  EXPECT_EQ(m[-2], Rational(1, 10));
  EXPECT_EQ(m[3], Rational(-2, 21));
  // f_2j = (1-u) c_j + u c_j+1, f_2j+1 = v c_j + (1-v) c_j+1.
  const Mask c = mask_of("corner-cutting:u=1/5,v=1/3");
  EXPECT_EQ(c[0], Rational(4, 5));
  EXPECT_EQ(c[-2], Rational(1, 5));
  EXPECT_EQ(c[1], Rational(1, 3));
  EXPECT_EQ(c[-1], Rational(2, 3));
  // Hassan et al. keep the old points and use a0 = -1/18 - mu/6 for the far one.
  const Mask t = mask_of("ternary-four-point:mu=1/11");
  EXPECT_EQ(t[0], 1);
  EXPECT_EQ(t[3], 0);
  EXPECT_EQ(t[4], Rational(-1, 18) - Rational(1, 66));
  EXPECT_EQ(mask_of("dubuc-deslauriers:points=6")[5], Rational(3, 256));
  EXPECT_EQ(mask_of("dubuc-deslauriers:points=8")[7], Rational(-5, 2048));
}

void expect_refused(const char* text, const char* part_of_message) {
  try {
    (void)parse_scheme(text);
    ADD_FAILURE() << "accepted " << text;
  } catch (const InvalidScheme& error) {
    EXPECT_NE(std::string(error.what()).find(part_of_message), std::string::npos)
        << text << " -> " << error.what();
  }
}

TEST(catalogue, bad_schemes_are_refused_with_what_where_and_remedy) {
  expect_refused("four-pont", "did you mean 'four-point'");
  expect_refused("", "there is no scheme");
  expect_refused("four-point:omga=1", "no parameter 'omga'; its parameters are omega");
  expect_refused("gentle:omega=1", "takes no parameters");
  expect_refused("four-point:omega", "is not key=value");
  expect_refused("four-point:omega=", "is not a number");
  expect_refused("four-point:omega=1/0", "denominator zero");
  expect_refused("four-point:omega=1,omega=1", "given twice");
  expect_refused("four-point:omega=99", "out of range; choose from -4 to 4");
  expect_refused("four-point:omega=1;2", "takes one number");
  expect_refused("b-spline:degree=2.5", "must be an integer");
  expect_refused("dubuc-deslauriers:points=5", "in steps of 2 from 4");
  expect_refused("mask:arity=2,first=0,coefficients=1;1;1", "sum to 2, 1; each must sum to 1");
  expect_refused("mask:arity=2,first=0", "coefficients is missing");
  expect_refused("mask:arity=1,first=0,coefficients=1", "out of range");
  expect_refused("difference:a0=1/2,a1=1/2,m=1", "they must sum to 2^-m = 1/2");
  expect_refused("difference:a0=1/4,a2=1/4,m=1", "without gaps");
  expect_refused("difference:m=1", "without gaps");
}

TEST(catalogue, phase_sums_of_every_member_are_one_by_construction) {
  EXPECT_THROW(Mask(2, 0, {Rational(1), Rational(1, 2)}), InvalidScheme);
  EXPECT_THROW(Mask(3, 0, {Rational(1), Rational(1)}), InvalidScheme);
  EXPECT_THROW(Mask(2, 0, {}), InvalidScheme);
  EXPECT_NO_THROW(Mask(3, -5, {Rational(1), Rational(1), Rational(1)}));
}

}  // namespace
}  // namespace arete
