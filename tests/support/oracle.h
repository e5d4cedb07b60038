// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "arete/algebra/rational.h"

namespace arete::test {

/// The records of one topic of tests/data/<file>; throws if there is none, so that a renamed topic
/// cannot make a test pass by being empty.
std::vector<nlohmann::json> oracle_records(const std::string& file, const std::string& topic);

inline std::vector<nlohmann::json> parametric_records(const std::string& topic) {
  return oracle_records("oracle-parametric.json", topic);
}

inline std::vector<nlohmann::json> ternary_and_reverse_records(const std::string& topic) {
  return oracle_records("oracle-ternary-and-reverse.json", topic);
}

/// An exact number of a record: the string "-3/64" or an integer.
Rational exact(const nlohmann::json& value);

std::vector<Rational> exact_list(const nlohmann::json& values);

}  // namespace arete::test
