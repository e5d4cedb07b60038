// SPDX-License-Identifier: MIT
#include "cli/survey_points.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fstream>

#include "cli/error.h"
#include "cli/interruption.h"
#include "cli/text_cells.h"

namespace arete::cli {
namespace {

using Cells = std::vector<std::string>;
using Columns = std::array<std::size_t, 3>;

constexpr std::array<const char*, 3> axis_names{"x", "y", "z"};
const std::array<std::vector<std::string>, 3> usual_names{
    {{"x", "east", "easting", "lon", "long", "longitude", "e"},
     {"y", "north", "northing", "lat", "latitude", "n"},
     {"z", "h", "height", "elev", "elevation", "alt", "altitude", "depth"}}};

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::string place(const std::string& path, long line) {
  return path + ", line " + std::to_string(line);
}

// A number; `1,5` too where commas do not separate cells.
std::optional<double> decimal_in(std::string cell) {
  const auto comma = cell.find(',');
  if (comma != std::string::npos) cell[comma] = '.';
  return number_in(cell);
}

std::optional<std::size_t> column_number(const std::string& text) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size() || number == 0) return std::nullopt;
  return number - 1;
}

class SurveyReader {
 public:
  SurveyReader(const std::string& path, const SurveyFormat& format)
      : path_(path), format_(format) {}

  SurveyPoints read() {
    std::ifstream stream(path_);
    if (!stream) throw Failure(path_ + " cannot be read; check the path");
    std::string line;
    while (std::getline(stream, line)) {
      ++number_;
      if (number_ % 65536 == 0) stop_if_interrupted();
      if (!line.empty() && line.back() == '\r') line.pop_back();
      if (number_ == 1 && line.rfind("\xEF\xBB\xBF", 0) == 0) line.erase(0, 3);
      if (!is_comment(line)) take(cells_of(line, separators()));
    }
    if (stream.bad()) throw Failure(path_ + " cannot be read to its end; the disk may be damaged");
    if (points_.x.empty())
      throw Failure(path_ + " holds no points; give lines like 3.5,-2,870 (x, y, height)");
    return std::move(points_);
  }

 private:
  static bool is_comment(const std::string& line) {
    const auto begin = line.find_first_not_of(" \t");
    if (begin == std::string::npos) return true;
    return line[begin] == '#' || line[begin] == '%' || line.compare(begin, 2, "//") == 0;
  }

  [[nodiscard]] std::string_view separators() const {
    return format_.separator.empty() ? any_separator : std::string_view(format_.separator);
  }

  // Finds the columns wanted from the first line; tells whether that is a header.
  bool find_columns(const Cells& first) {
    bool header = false;
    if (format_.columns)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto number = column_number((*format_.columns)[axis]);
        header = header || !number;
        columns_[axis] = number ? *number : named(first, {lower((*format_.columns)[axis])}).value();
      }
    for (const std::size_t c : columns_) need_column(first, c);
    const auto is_number = [&](std::size_t c) { return decimal_in(first[c]).has_value(); };
    header = header || std::none_of(columns_.begin(), columns_.end(), is_number);
    if (header && !format_.columns) find_usual_names(first);
    return header;
  }

  void find_usual_names(const Cells& header) {
    std::array<std::optional<std::size_t>, 3> found;
    for (std::size_t axis = 0; axis < 3; ++axis) found[axis] = named(header, usual_names[axis]);
    const auto known = std::count_if(found.begin(), found.end(), [](const auto& c) { return !!c; });
    if (known == 3)
      for (std::size_t axis = 0; axis < 3; ++axis) columns_[axis] = *found[axis];
    // Taking the other columns by their number could mistake a running number for a height.
    else if (known > 0)
      throw Failure(place(path_, number_) +
                    ": the header names some of x, y and z but not all; choose the columns with "
                    "--columns, e.g. --columns x,y,value");
  }

  [[nodiscard]] std::optional<std::size_t> named(const Cells& header,
                                                 const std::vector<std::string>& names) const {
    for (std::size_t c = 0; c < header.size(); ++c)
      if (std::count(names.begin(), names.end(), lower(header[c])) > 0) return c;
    if (format_.columns)
      throw Failure(place(path_, number_) + " has no column '" + names.front() +
                    "'; name one of its header, or give numbers (from 1)");
    return std::nullopt;
  }

  void need_column(const Cells& cells, std::size_t column) const {
    if (column < cells.size()) return;
    throw Failure(
        place(path_, number_) + " has " + std::to_string(cells.size()) + " columns where column " +
        std::to_string(column + 1) +
        " is needed; every line must hold x, y and a height (choose them with --columns)");
  }

  void take(const Cells& cells) {
    if (!columns_known_) {
      columns_known_ = true;
      if (find_columns(cells)) return;
    }
    std::array<double, 3> point{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t c = columns_[axis];
      need_column(cells, c);
      const auto value = decimal_in(cells[c]);
      if (!value)
        throw Failure(place(path_, number_) + ", column " + std::to_string(c + 1) + " (" +
                      axis_names[axis] + "): '" + cells[c].substr(0, 40) +
                      "' is not a number; correct it or choose other columns with --columns");
      point[axis] = *value;
    }
    points_.x.push_back(point[0]);
    points_.y.push_back(point[1]);
    points_.z.push_back(point[2]);
  }

  const std::string& path_;
  const SurveyFormat& format_;
  SurveyPoints points_;
  Columns columns_{0, 1, 2};
  bool columns_known_ = false;
  long number_ = 0;
};

}  // namespace

SurveyPoints read_survey(const std::string& path, const SurveyFormat& format) {
  if (format.separator.size() > 1)
    throw Misuse("--separator takes one character, e.g. ';' (got '" + format.separator + "')");
  return SurveyReader(path, format).read();
}

std::array<std::string, 3> parse_columns(const std::string& text) {
  const auto names = cells_of(text, ",");
  if (names.size() != 3 || std::count(names.begin(), names.end(), "") > 0)
    throw Misuse("--columns takes three names or numbers, e.g. x,y,z or 2,3,5 (got '" + text +
                 "')");
  return {names[0], names[1], names[2]};
}

}  // namespace arete::cli
