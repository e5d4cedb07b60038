// SPDX-License-Identifier: MIT
// Every record of the oracle files has to be met by some test. Records are read by topic, all of a
// topic at once (support/oracle.h), so a topic that no test asks for is a set of records unmet.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "support/source_dir.h"

namespace arete {
namespace {

const std::filesystem::path tests_folder = arete::test::source_dir() + "/tests";

std::string text_of(const std::filesystem::path& path) {
  std::ifstream stream(path);
  EXPECT_TRUE(stream) << path;
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::map<std::string, int> records_by_topic(const char* file) {
  const auto document = nlohmann::json::parse(text_of(tests_folder / "data" / file));
  std::map<std::string, int> counts;
  for (const auto& record : document.at("records")) ++counts[record.at("topic").get<std::string>()];
  return counts;
}

// Topics that some test reads with the given function.
std::set<std::string> topics_read_with(const std::string& function) {
  const std::regex call(function + "\\(\\s*\"([^\"]+)\"");
  std::set<std::string> topics;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(tests_folder)) {
    if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
    const std::string text = text_of(entry.path());
    for (std::sregex_iterator found(text.begin(), text.end(), call), end; found != end; ++found)
      topics.insert((*found)[1]);
  }
  return topics;
}

void expect_all_read(const char* file, const char* function) {
  const auto records = records_by_topic(file);
  const auto read = topics_read_with(function);
  int total = 0;
  for (const auto& [topic, count] : records) {
    total += count;
    EXPECT_TRUE(read.count(topic) == 1)
        << file << ": no test reads the " << count << " records of topic " << topic;
  }
  for (const std::string& topic : read)
    EXPECT_TRUE(records.count(topic) == 1) << file << " has no topic " << topic;
  EXPECT_GT(total, 100);
}

TEST(OracleTopics, every_topic_of_the_parametric_records_is_met_by_a_test) {
  expect_all_read("oracle-parametric.json", "parametric_records");
}

TEST(OracleTopics, every_topic_of_the_ternary_and_reverse_records_is_met_by_a_test) {
  expect_all_read("oracle-ternary-and-reverse.json", "ternary_and_reverse_records");
}

}  // namespace
}  // namespace arete
