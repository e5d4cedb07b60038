// SPDX-License-Identifier: MIT
// What each family is known for, as numbers of the literature instead of its own masks: sum rules,
// degree of the polynomials reproduced, parametric shift, interpolation, symmetry. A weight that is
// off breaks at least one (scripts/check-mutations).
#include <gtest/gtest.h>

#include <algorithm>

#include "arete/analysis/polynomial.h"
#include "arete/scheme/catalogue.h"

namespace arete {
namespace {

struct Promise {
  const char* scheme;
  int sum_rules;
  int degree;  ///< reproduced
  const char* tau;
  bool interpolates;
  bool symmetric;  ///< the mask read backwards is the mask
};

const Promise promises[]{
    {"four-parameter:lambda=1/5,mu=1/10,nu=1/3,omega=1/7", 1, 0, "61/210", false, false},
    {"four-parameter:lambda=3/32,mu=1/32,nu=1/4,omega=1/32", 3, 1, "1/8", false, false},
    {"four-parameter:lambda=11/200,mu=-9/200,nu=7/24,omega=3/50", 3, 2, "1/5", false, false},
    {"four-point", 4, 3, "0", true, true},
    {"four-point:omega=0.03", 2, 1, "0", true, true},
    {"four-parameter-c2:nu=3/4,omega=1/40", 3, 1, "-1/10", false, false},
    {"gentle", 2, 1, "0", false, true},
    {"craggy", 2, 1, "0", false, true},
    {"two-parameter:a=1/7", 3, 1, "11/14", false, false},
    {"two-parameter:a=1/3,m=2,raise=0", 3, 1, "5/6", false, false},
    {"three-parameter", 4, 1, "0", false, true},
    {"three-parameter:a=1/5,c=-1/3", 4, 1, "32/15", false, false},
    {"difference:a0=1/10,a1=0,a2=3/20,a3=1/4,m=1,raise=1", 4, 1, "3/5", false, false},
    {"three-point", 3, 2, "0", true, false},
    {"ternary-two-step", 3, 2, "1/2", false, true},
    {"ternary-two-step:b=-3/8", 3, 2, "1/2", false, true},
    {"ternary-two-step-9", 3, 2, "0", true, true},
    {"ternary-four-point", 3, 2, "0", true, true},
    {"corner-cutting:u=1/5,v=3/10", 2, 1, "-2/5", false, false},
    {"chaikin", 3, 1, "-1/2", false, true},
    {"de-rham", 1, 0, "-1/2", false, true},
    {"b-spline:degree=1", 2, 1, "0", true, true},
    {"b-spline:degree=2", 3, 1, "1/2", false, true},
    {"b-spline:degree=3", 4, 1, "0", false, true},
    {"b-spline:degree=4", 5, 1, "1/2", false, true},
    {"b-spline:degree=5", 6, 1, "0", false, true},
    {"dubuc-deslauriers:points=6", 6, 5, "0", true, true},
    {"dubuc-deslauriers:points=8", 8, 7, "0", true, true},
};

TEST(catalogue_laws, every_family_keeps_what_it_promises) {
  for (const Promise& promise : promises) {
    SCOPED_TRACE(promise.scheme);
    const Mask mask = parse_scheme(promise.scheme).mask();
    EXPECT_EQ(sum_rules(mask), promise.sum_rules);
    EXPECT_EQ(reproduction_degree(mask), promise.degree);
    EXPECT_EQ(to_string(mask.tau()), promise.tau);
    EXPECT_EQ(is_interpolatory(mask), promise.interpolates);
    const std::vector<Rational>& forward = mask.coefficients();
    EXPECT_EQ(std::equal(forward.begin(), forward.end(), forward.rbegin()), promise.symmetric);
  }
}

TEST(catalogue_laws, promises_are_made_for_every_family) {
  for (const Family& family : catalogue()) {
    if (family.name == "mask") continue;  // whoever gives the weights makes the promises
    EXPECT_TRUE(std::any_of(std::begin(promises), std::end(promises), [&](const Promise& promise) {
      return parse_scheme(promise.scheme).name() == family.name;
    })) << family.name;
  }
}

}  // namespace
}  // namespace arete
