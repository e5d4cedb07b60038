// SPDX-License-Identifier: MIT
// What the documents show is what the program prints. A block
//
//     ```console
//     $ arete analyze gentle
//     C^1 certified, not C^2
//     ```
//
// is run by a shell, in one folder per document that sees data/; every line below a command has to
// be in what it prints, blanks aside. A command may end with a non-zero code only if its block says
// so in its last line, `(exit code 2)`.
#include <gtest/gtest.h>

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <vector>

#include "arete/scheme/catalogue.h"
#include "run_program.h"
#include "support/source_dir.h"
#include "support/temporary_folder.h"

namespace arete {
namespace {

struct Command {
  int line = 0;
  std::string text;
  std::vector<std::string> expected;
  int exit_code = 0;
};

std::vector<Command> commands_of(const std::filesystem::path& document) {
  std::ifstream stream(document);
  EXPECT_TRUE(stream) << document;
  std::vector<Command> commands;
  bool inside = false;
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (line.starts_with("```")) {
      inside = !inside && line == "```console";
      continue;
    }
    if (!inside || line.empty()) continue;
    if (line.starts_with("$ ")) {
      commands.push_back({number, line.substr(2), {}, 0});
    } else if (!commands.empty() && commands.back().text.ends_with("\\")) {
      commands.back().text.pop_back();
      commands.back().text += line;
    } else if (line.starts_with("(exit code ")) {
      commands.back().exit_code = std::stoi(line.substr(11));
    } else {
      commands.back().expected.push_back(line);
    }
  }
  return commands;
}

std::string without_blanks(const std::string& text) {
  std::string rest;
  for (const char c : text)
    if (c != ' ' && c != '\n' && c != '\t') rest += c;
  return rest;
}

std::string shell(const std::string& folder, const std::string& command, int& exit_code) {
  const std::string program = arete::test::program_path();
  const std::string path = std::filesystem::path(program).parent_path().string();
  const std::string line =
      "cd '" + folder + "' && PATH='" + path + "':$PATH && { " + command + "\n} 2>&1";
  std::string output;
  FILE* pipe = popen(line.c_str(), "r");
  std::array<char, 4096> buffer{};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe))
    output.append(buffer.data(), count);
  const int status = pclose(pipe);
  exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return output;
}

// docs/schemes/NAME.md holds, between two marks, what the program says of the family.
TEST(documents, have_a_page_for_every_family_with_its_facts) {
  const std::filesystem::path pages = arete::test::source_dir() + "/docs/schemes";
  std::size_t count = 0;
  for (const Family& family : catalogue()) {
    const auto page = pages / (family.name + ".md");
    std::ifstream stream(page);
    ASSERT_TRUE(stream) << page << " is missing";
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    const std::string begin = "<!-- arete schemes --markdown " + family.name + " -->\n";
    const auto first = text.find(begin);
    ASSERT_NE(first, std::string::npos) << page << " lacks the mark " << begin;
    const auto last = text.find("<!-- end -->", first);
    ASSERT_NE(last, std::string::npos) << page;
    const auto run = test::run_arete({"schemes", "--markdown", family.name});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(text.substr(first + begin.size(), last - first - begin.size()), run.out)
        << page << " is out of date: run scripts/family-pages";
    // Pictures that it shows are there.
    const std::regex picture("\\]\\(([^)]*\\.png)\\)");
    for (std::sregex_iterator at(text.begin(), text.end(), picture), end; at != end; ++at)
      EXPECT_TRUE(std::filesystem::exists(pages / (*at)[1].str())) << page << ": " << (*at)[1];
    ++count;
  }
  EXPECT_EQ(count, catalogue().size());
}

class console_blocks : public testing::TestWithParam<const char*> {};

TEST_P(console_blocks, show_what_the_program_prints) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory_symlink(arete::test::source_dir() + "/data",
                                            folder.file("data"));
  const auto commands = commands_of(arete::test::source_dir() + "/docs/" + GetParam());
  EXPECT_FALSE(commands.empty());
  for (const Command& command : commands) {
    int exit_code = 0;
    const std::string output = shell(folder.path().string(), command.text, exit_code);
    EXPECT_EQ(exit_code, command.exit_code)
        << "docs/" << GetParam() << ":" << command.line << ": " << command.text << "\n"
        << output;
    const std::string printed = without_blanks(output);
    for (const std::string& line : command.expected)
      EXPECT_NE(printed.find(without_blanks(line)), std::string::npos)
          << "docs/" << GetParam() << ":" << command.line << ": " << command.text
          << "\ndoes not print\n"
          << line << "\nbut\n"
          << output;
  }
}

INSTANTIATE_TEST_SUITE_P(documents, console_blocks,
                         testing::Values("errata.md", "smoothness.md", "geometric-smoothness.md"),
                         [](const auto& info) {
                           std::string name = info.param;
                           for (char& c : name)
                             if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
                           return name;
                         });

}  // namespace
}  // namespace arete
