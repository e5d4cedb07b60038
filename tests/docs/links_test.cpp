// SPDX-License-Identifier: MIT
// The pages lead where they say: every relative link and picture of a Markdown file is there, and
// every heading that a link names exists.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "support/source_dir.h"

namespace {

namespace fs = std::filesystem;
const fs::path root = arete::test::source_dir();

std::vector<fs::path> pages() {
  std::vector<fs::path> found;
  for (auto entry = fs::recursive_directory_iterator(root);
       entry != fs::recursive_directory_iterator(); ++entry) {
    const std::string name = entry->path().filename().string();
    if (entry->is_directory() && (name == "build" || name == "out" || name[0] == '.'))
      entry.disable_recursion_pending();
    else if (entry->path().extension() == ".md")
      found.push_back(entry->path());
  }
  return found;
}

std::string text_of(const fs::path& path) {
  std::ifstream stream(path);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

// The text without code, in which brackets and parentheses mean other things.
std::string prose(const std::string& text) {
  std::string without;
  std::istringstream lines(text);
  bool code = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("```") != std::string::npos) code = !code;
    if (!code) without += std::regex_replace(line, std::regex("`[^`]*`"), "code") + "\n";
  }
  return without;
}

// Headings as GitHub makes anchors of them.
std::set<std::string> anchors_of(const fs::path& page) {
  std::set<std::string> anchors;
  std::istringstream lines(text_of(page));
  bool code = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("```") != std::string::npos) code = !code;
    if (code || line.empty() || line[0] != '#') continue;
    std::string anchor;
    for (const char c : line.substr(line.find_first_not_of("# "))) {
      const auto u = static_cast<unsigned char>(c);
      if (std::isalnum(u) || c == '-' || c == '_')
        anchor += static_cast<char>(std::tolower(u));
      else if (c == ' ')
        anchor += '-';
    }
    anchors.insert(anchor);
  }
  return anchors;
}

TEST(docs, every_relative_link_leads_to_a_file_and_a_heading_that_exist) {
  const std::regex link(R"(\]\(([^()\s]+)\))");
  int followed = 0;
  for (const fs::path& page : pages()) {
    const std::string text = prose(text_of(page));
    for (std::sregex_iterator match(text.begin(), text.end(), link), end; match != end; ++match) {
      const std::string target = (*match)[1];
      if (target.find("://") != std::string::npos || target.rfind("mailto:", 0) == 0) continue;
      const auto hash = target.find('#');
      const fs::path file = hash == 0 ? page : page.parent_path() / target.substr(0, hash);
      EXPECT_TRUE(fs::exists(file)) << page << " links to " << target;
      if (hash != std::string::npos && fs::exists(file)) {
        EXPECT_TRUE(anchors_of(file).count(target.substr(hash + 1)))
            << page << " links to the heading " << target;
      }
      ++followed;
    }
  }
  EXPECT_GT(followed, 20);
}

TEST(docs, every_page_is_reached_from_another) {
  std::string all;
  for (const fs::path& page : pages()) all += text_of(page);
  for (const fs::path& page : pages())
    if (page.parent_path() == root / "docs") {
      EXPECT_NE(all.find(page.filename().string()), std::string::npos)
          << page << " is named by no other page";
    }
}

}  // namespace
