// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "arete/field/grid.h"

namespace arete::cli {

/// A table of points: one a row, one coordinate a column.
struct Points {
  std::vector<std::string> header;  ///< names of the columns; empty when the file has none
  Grid<double> values;
};

/// Reads points from a text file: columns separated by comma, semicolon, tab or blanks; empty lines
/// and lines that begin with # are passed over; a first line that is not all numbers is the header.
/// \throws Failure naming file, line and column for an unreadable or empty file, a text where a
/// number should be, a number that is not finite, or rows of different lengths.
[[nodiscard]] Points read_points(const std::string& path);

/// Writes points with enough digits to be read back exactly. \throws Failure
void write_points(const std::filesystem::path& path, const Points& points);

}  // namespace arete::cli
