// SPDX-License-Identifier: MIT
#include "cli/text_cells.h"

#include <charconv>

namespace arete::cli {

namespace {

// The first of the separators, in their order, that the line has outside of quotes.
std::optional<char> separator_in(std::string_view line, std::string_view separators) {
  for (const char separator : separators) {
    bool quoted = false;
    for (const char c : line) {
      if (c == '"') quoted = !quoted;
      if (!quoted && c == separator) return c;
    }
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::string> cells_of(std::string_view line, std::string_view separators) {
  // Of blanks several are one separator; commas without anything between are an empty cell.
  const std::optional<char> separator = separator_in(line, separators);
  const bool marked = separator && *separator != ' ';
  std::vector<std::string> cells;
  std::string cell;
  bool quoted = false;
  const auto finish = [&] {
    const auto first = cell.find_first_not_of(" \"");
    const auto last = cell.find_last_not_of(" \"");
    cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
    cell.clear();
  };
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    const bool separates = marked ? c == *separator : c == ' ' || c == '\t';
    if (quoted || !separates)
      cell += c;
    else if (marked || !cell.empty())
      finish();
  }
  if (marked || !cell.empty()) finish();
  return cells;
}

std::optional<double> number_in(std::string_view cell) {
  if (!cell.empty() && cell.front() == '+') cell.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc{} || end != cell.data() + cell.size()) return std::nullopt;
  return value;
}

}  // namespace arete::cli
