// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "arete/scheme/catalogue.h"

namespace arete::test {

/// At least one member of every family of the catalogue, the asymmetric and extreme ones among
/// them. laws/catalogue_laws_test.cpp checks that no family is missing.
inline std::vector<Scheme> sample_schemes() {
  std::vector<Scheme> schemes;
  for (const char* text : {"four-parameter:lambda=1/5,mu=1/10,nu=1/3,omega=1/7",
                           "four-parameter:lambda=3/32,mu=1/32,nu=1/4,omega=1/32",
                           "four-parameter:lambda=11/200,mu=-9/200,nu=7/24,omega=3/50",
                           "four-point",
                           "four-point:omega=0.03",
                           "four-parameter-c2:nu=3/4,omega=1/40",
                           "gentle",
                           "craggy",
                           "two-parameter:a=1/7",
                           "two-parameter:a=1/3,m=2,raise=0",
                           "three-parameter",
                           "three-parameter:a=1/5,c=-1/3",
                           "difference:a0=1/10,a1=0,a2=3/20,a3=1/4,m=1,raise=1",
                           "three-point",
                           "ternary-two-step",
                           "ternary-two-step:b=-3/8",
                           "ternary-two-step-9",
                           "ternary-four-point",
                           "corner-cutting:u=1/5,v=3/10",
                           "chaikin",
                           "de-rham",
                           "b-spline:degree=1",
                           "b-spline:degree=2",
                           "b-spline:degree=3",
                           "b-spline:degree=4",
                           "b-spline:degree=5",
                           "dubuc-deslauriers:points=6",
                           "dubuc-deslauriers:points=8",
                           "mask:arity=4,first=-2,coefficients=1/8;3/8;5/8;7/8;7/8;5/8;3/8;1/8"})
    schemes.push_back(parse_scheme(text));
  return schemes;
}

}  // namespace arete::test
