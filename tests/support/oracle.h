// SPDX-License-Identifier: MIT
#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "arete/algebra/rational.h"
#include "support/source_dir.h"

namespace arete::test {

/// The records of one topic of tests/data/<file>; throws if there is none, so that a renamed topic
/// cannot make a test pass by being empty.
inline std::vector<nlohmann::json> oracle_records(const std::string& file,
                                                  const std::string& topic) {
  std::ifstream stream(arete::test::source_dir() + "/tests/data/" + file);
  if (!stream) throw std::runtime_error("cannot open tests/data/" + file);
  const nlohmann::json all = nlohmann::json::parse(stream);
  std::vector<nlohmann::json> found;
  for (const auto& record : all.at("records"))
    if (record.at("topic") == topic) found.push_back(record);
  if (found.empty()) throw std::runtime_error("no records of topic " + topic + " in " + file);
  return found;
}

inline std::vector<nlohmann::json> parametric_records(const std::string& topic) {
  return oracle_records("oracle-parametric.json", topic);
}

inline std::vector<nlohmann::json> ternary_and_reverse_records(const std::string& topic) {
  return oracle_records("oracle-ternary-and-reverse.json", topic);
}

/// An exact number of a record: the string "-3/64" or an integer.
inline Rational exact(const nlohmann::json& value) {
  return value.is_string() ? parse_rational(value.get<std::string>())
                           : Rational(value.get<long long>());
}

inline std::vector<Rational> exact_list(const nlohmann::json& values) {
  std::vector<Rational> numbers;
  for (const auto& value : values) numbers.push_back(exact(value));
  return numbers;
}

}  // namespace arete::test
