// SPDX-License-Identifier: MIT
#include "cli/option_facts.h"

#include <sstream>

namespace arete::cli {

std::vector<const CLI::App*> visible_verbs(const CLI::App& program) {
  return program.get_subcommands([](const CLI::App* verb) { return !verb->get_group().empty(); });
}

std::vector<std::string> spellings(const CLI::Option& option) {
  std::vector<std::string> found;
  for (const std::string& name : option.get_snames()) found.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) found.push_back("--" + name);
  return found;
}

bool takes_value(const CLI::Option& option) { return option.get_expected_max() > 0; }

std::vector<std::string> accepted_words(const CLI::Option& option) {
  // CLI11 appends the set of an IsMember check to the type's name: TEXT:{nodes,cells}.
  const std::string type = option.get_type_name();
  const auto open = type.find('{');
  const auto close = type.find('}', open);
  if (open == std::string::npos || close == std::string::npos) return {};
  std::istringstream stream(type.substr(open + 1, close - open - 1));
  std::vector<std::string> words;
  for (std::string word; std::getline(stream, word, ',');) words.push_back(word);
  return words;
}

}  // namespace arete::cli
