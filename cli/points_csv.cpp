// SPDX-License-Identifier: MIT
#include "cli/points_csv.h"

#include <charconv>
#include <cmath>
#include <fstream>

#include "cli/error.h"
#include "cli/text_cells.h"

namespace arete::cli {
namespace {

std::string place(const std::string& path, int line) {
  return path + ", line " + std::to_string(line);
}

}  // namespace

Points read_points(const std::string& path) {
  std::ifstream stream(path);
  if (!stream) throw Failure(path + " cannot be read; check the path");
  Points points;
  std::vector<double> values;
  std::size_t columns = 0;
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (number == 1 && line.rfind("\xEF\xBB\xBF", 0) == 0) line.erase(0, 3);
    const auto begin = line.find_first_not_of(" \t");
    if (begin == std::string::npos || line[begin] == '#') continue;
    const std::vector<std::string> cells = cells_of(line);
    if (columns != 0 && cells.size() != columns)
      throw Failure(place(path, number) + " has " + std::to_string(cells.size()) +
                    " columns where the lines before have " + std::to_string(columns));
    std::vector<double> row;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const auto value = number_in(cells[c]);
      if (!value && columns == 0) {
        points.header = cells;
        break;
      }
      if (!value || !std::isfinite(*value))
        throw Failure(place(path, number) + ", column " + std::to_string(c + 1) + ": '" +
                      cells[c].substr(0, 40) + "' is not a finite number");
      row.push_back(*value);
    }
    columns = cells.size();
    if (row.size() == columns) values.insert(values.end(), row.begin(), row.end());
  }
  if (stream.bad() || columns == 0 || values.empty())
    throw Failure(path + " holds no points; give lines like 3.5,-2");
  points.values =
      Grid<double>({static_cast<Index>(values.size() / columns), static_cast<Index>(columns)});
  points.values.samples() = std::move(values);
  return points;
}

void write_points(const std::filesystem::path& path, const Points& points) {
  std::ofstream stream(path, std::ios::binary);
  for (std::size_t c = 0; c < points.header.size(); ++c)
    stream << (c == 0 ? "" : ",") << points.header[c];
  if (!points.header.empty()) stream << '\n';
  char text[64];
  for (Index r = 0; r < points.values.rows(); ++r) {
    for (Index c = 0; c < points.values.cols(); ++c) {
      // The shortest text that reads back as the same double.
      const auto end = std::to_chars(text, text + sizeof text, points.values(r, c)).ptr;
      if (c != 0) stream << ',';
      stream.write(text, end - text);
    }
    stream << '\n';
  }
  stream.close();
  if (!stream) throw Failure(path.string() + " cannot be written; check free space");
}

}  // namespace arete::cli
