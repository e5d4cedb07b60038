// SPDX-License-Identifier: MIT
#include "support/oracle.h"

#include <fstream>
#include <stdexcept>

#include "support/source_dir.h"

namespace arete::test {

std::vector<nlohmann::json> oracle_records(const std::string& file, const std::string& topic) {
  std::ifstream stream(source_dir() + "/tests/data/" + file);
  if (!stream) throw std::runtime_error("cannot open tests/data/" + file);
  const nlohmann::json all = nlohmann::json::parse(stream);
  std::vector<nlohmann::json> found;
  for (const auto& record : all.at("records"))
    if (record.at("topic") == topic) found.push_back(record);
  if (found.empty()) throw std::runtime_error("no records of topic " + topic + " in " + file);
  return found;
}

Rational exact(const nlohmann::json& value) {
  return value.is_string() ? parse_rational(value.get<std::string>())
                           : Rational(value.get<long long>());
}

std::vector<Rational> exact_list(const nlohmann::json& values) {
  std::vector<Rational> numbers;
  for (const auto& value : values) numbers.push_back(exact(value));
  return numbers;
}

}  // namespace arete::test
