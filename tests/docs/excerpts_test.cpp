// SPDX-License-Identifier: MIT
// The C++ of the tutorial is code that is compiled and run: every ```cpp block of docs/cpp.md
// stands, line by line, in one of the examples.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "support/source_dir.h"

namespace {

namespace fs = std::filesystem;

// Blanks are clang-format's business: it breaks lines by how deep they stand.
std::string without_blanks(const std::string& text) {
  std::string rest;
  for (const char c : text)
    if (c != ' ' && c != '\n') rest += c;
  return rest;
}

std::string text_of(const fs::path& path) {
  std::ifstream stream(path);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::vector<std::string> cpp_blocks(const fs::path& page) {
  std::vector<std::string> blocks;
  std::istringstream lines(text_of(page));
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```")) {
      inside = line == "```cpp";
      if (inside) blocks.emplace_back();
    } else if (inside) {
      blocks.back() += line + "\n";
    }
  }
  return blocks;
}

TEST(docs, the_tutorial_in_cpp_shows_lines_of_the_examples) {
  const fs::path root = arete::test::source_dir();
  std::vector<std::string> examples;
  for (const auto& entry : fs::directory_iterator(root / "examples"))
    if (entry.path().extension() == ".cpp")
      examples.push_back(without_blanks(text_of(entry.path())));
  const auto blocks = cpp_blocks(root / "docs" / "cpp.md");
  EXPECT_GE(blocks.size(), 8U);
  for (const std::string& block : blocks) {
    bool found = false;
    for (const std::string& example : examples)
      found |= example.find(without_blanks(block)) != std::string::npos;
    EXPECT_TRUE(found) << "no example holds\n" << block;
  }
}

}  // namespace
