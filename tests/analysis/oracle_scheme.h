// SPDX-License-Identifier: MIT
#pragma once

#include "arete/scheme/catalogue.h"
#include "support/oracle.h"

namespace arete::test {

/// The mask that the "input" of a parametric record names.
inline Mask mask_of(const nlohmann::json& input) {
  const auto value = [&input](const char* key) {
    return ParameterValue{key, {exact(input.at(key))}};
  };
  const std::string scheme = input.at("scheme");
  if (scheme == "four_parameter")
    return make_scheme("four-parameter",
                       {value("lambda"), value("mu"), value("nu"), value("omega")})
        .mask();
  if (scheme == "paper1_(3)")
    return make_scheme("two-parameter", {value("a"), {"m", {1}}, {"raise", {1}}}).mask();
  if (scheme == "paper1_(5)")
    return make_scheme("three-parameter", {value("a"), value("c"), {"m", {2}}, {"raise", {1}}})
        .mask();
  throw std::runtime_error("unknown scheme of a record: " + scheme);
}

inline Mask ternary_mask(const nlohmann::json& input) {
  return make_scheme("ternary-two-step", {{"b", {exact(input.at("b"))}}}).mask();
}

}  // namespace arete::test
