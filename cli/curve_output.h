// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/points_csv.h"

namespace arete::cli {

/// A further column of a table of points: one number a point.
struct Column {
  std::string name;
  std::vector<double> values;
};

/// A curve on its way to a file.
struct CurveFile {
  Grid<double> points;
  std::vector<std::string> header;  ///< of the coordinates; empty: the table gets no header
  bool closed = false;
  std::vector<double> tau;      ///< the parameter of every point, or empty; .vtp always takes it
  std::vector<Column> columns;  ///< for .csv only, in this order
  Grid<double> control{};       ///< drawn below the curve in a .png, unless there are too many
};

/// \throws Misuse unless the name ends in .csv, .vtp or .png. \throws Failure for a format that
/// this program was built without.
void check_curve_form(const std::string& output);

/// Writes what the extension of `path` says. \throws Failure, InvalidField (a .vtp or .png needs
/// two or three coordinates and at least two points)
void write_curve(const CurveFile& curve, const std::filesystem::path& path);

}  // namespace arete::cli
