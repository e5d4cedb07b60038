// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace arete::cli {

/// Heights at places, as three equally long arrays.
struct SurveyPoints {
  std::vector<double> x, y, z;
  std::string crs;  ///< WKT; empty when the file names none
};

/// How a text file of points is read.
struct SurveyFormat {
  /// Names or numbers (from 1) of the columns of x, y and z. Without them: the columns whose
  /// header names are x, y, z or usual words for them, otherwise the first three.
  std::optional<std::array<std::string, 3>> columns;
  /// One character, or empty for comma, semicolon, tab, bar or blanks, whatever a line has.
  std::string separator;
};

/// Reads points from text: one a line; empty lines and those that begin with #, % or // are passed
/// over; a first line without numbers in the columns wanted is the header; other columns may hold
/// anything; a comma is a decimal point where cells are separated by another sign. NaN counts as
/// a number.
/// \throws Failure naming file, line and column for an unreadable or empty file, a missing column,
/// or a text where a number should be; Misuse for columns or separators that cannot be.
[[nodiscard]] SurveyPoints read_survey(const std::string& path, const SurveyFormat& format);

/// `x,y,z` or `2,3,5` as three columns. \throws Misuse
[[nodiscard]] std::array<std::string, 3> parse_columns(const std::string& text);

}  // namespace arete::cli
