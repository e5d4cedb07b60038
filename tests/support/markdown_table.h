// SPDX-License-Identifier: MIT
#pragma once

#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/source_dir.h"

namespace arete::test {

/// The body rows of the first table below the heading that begins with these words, in a document
/// of the tree. Blanks around cells and back-quotes are dropped. Throws if there is none, so that a
/// renamed heading cannot make a test pass by being empty.
inline std::vector<std::vector<std::string>> markdown_table(const std::string& file,
                                                            const std::string& heading) {
  std::ifstream stream(arete::test::source_dir() + "/" + file);
  if (!stream) throw std::runtime_error("cannot open " + file);
  std::vector<std::vector<std::string>> rows;
  bool below = false;
  int line_of_table = 0;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("#")) {
      if (line_of_table > 0) break;
      const auto words = line.find_first_not_of("# ");
      below = words != std::string::npos && line.compare(words, heading.size(), heading) == 0;
    }
    if (!below) continue;
    if (!line.starts_with("|")) {
      if (line_of_table > 0) break;
      continue;
    }
    if (++line_of_table <= 2) continue;  // header and rule
    std::vector<std::string> cells(1);
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      if (line[i] == '|')
        cells.emplace_back();
      else if (line[i] != '`')
        cells.back() += line[i];
    }
    for (std::string& cell : cells) {
      const auto first = cell.find_first_not_of(' ');
      const auto last = cell.find_last_not_of(' ');
      cell = first == std::string::npos ? "" : cell.substr(first, last - first + 1);
    }
    rows.push_back(std::move(cells));
  }
  if (rows.empty()) throw std::runtime_error(file + " has no table below '" + heading + "'");
  return rows;
}

}  // namespace arete::test
