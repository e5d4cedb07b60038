// SPDX-License-Identifier: MIT
// Manual and completion say what the program itself says.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "cli/run_program.h"
#include "support/temporary_folder.h"

namespace arete::test {
namespace {

std::string text_of(const std::string& path) {
  std::ifstream stream(path);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::vector<std::string> long_options(const std::string& help) {
  const std::regex option("\n  (?:-[a-z],)?(--[a-z-]+)");
  std::vector<std::string> found;
  for (std::sregex_iterator match(help.begin(), help.end(), option), end; match != end; ++match)
    found.push_back((*match)[1]);
  return found;
}

std::vector<std::string> verbs(const std::string& help) {
  std::vector<std::string> found;
  std::istringstream lines(help.substr(help.find("Subcommands:")));
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line))
    if (line.size() > 2 && line[2] != ' ') found.push_back(line.substr(2, line.find(' ', 2) - 2));
  return found;
}

TEST(cli_generate, every_verb_has_a_page_that_names_every_option_of_its_help) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_arete({"generate", "man", folder.path().string()}).exit_code, 0);
  const std::vector<std::string> all = verbs(run_arete({"--help"}).out);
  ASSERT_GT(all.size(), 10u);
  EXPECT_EQ(folder.entries(), static_cast<int>(all.size()) + 1);
  const std::string overview = text_of(folder.file("arete.1"));
  for (const std::string& verb : all) {
    EXPECT_NE(overview.find("\\fB" + verb + "\\fR"), std::string::npos) << verb;
    const std::string page = text_of(folder.file("arete-" + verb + ".1"));
    for (const std::string& option : long_options(run_arete({verb, "--help"}).out))
      EXPECT_NE(page.find(std::regex_replace(option, std::regex("-"), "\\-")), std::string::npos)
          << verb << " " << option;
  }
}

// What bash offers after these words.
std::string completed(const std::string& script, const std::string& words) {
  const std::string command = "bash -c 'source " + script + "; COMP_WORDS=(" + words +
                              "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _arete; "
                              "echo \" ${COMPREPLY[*]} \"'";
  FILE* pipe = popen(command.c_str(), "r");
  std::string out;
  for (int c; (c = std::fgetc(pipe)) != EOF;) out += static_cast<char>(c);
  pclose(pipe);
  return out;
}

TEST(cli_generate, bash_completes_verbs_options_words_and_schemes) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_arete({"generate", "bash-completion", folder.path().string()}).exit_code, 0);
  const std::string script = folder.file("arete");
  EXPECT_EQ(completed(script, "arete rend"), " render \n");
  EXPECT_EQ(completed(script, "arete refine a b --scheme gen"), " gentle \n");
  EXPECT_EQ(completed(script, "arete describe chai"), " chaikin \n");
  EXPECT_EQ(completed(script, "arete refine a b --align ce"), " cells \n");
  EXPECT_EQ(completed(script, "arete refine a b --thre"), " --threads \n");
}

}  // namespace
}  // namespace arete::test
