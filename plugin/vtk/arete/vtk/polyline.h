// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "arete/field/grid.h"

namespace arete::vtk {

/// A polygon line, borrowed: one row a point, two or three columns. A closed one does not repeat
/// its first point at the end.
struct Polyline {
  GridView<const double> points;
  bool closed = false;
  /// The parameter at every point; empty if there is none.
  std::span<const double> tau{};
};

/// \throws InvalidField unless there are 2 or 3 columns, at least two points (three if closed), all
/// coordinates finite, and as many parameters as points or none.
void check_polyline(const Polyline& line);

}  // namespace arete::vtk
