// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "arete/field/grid.h"
#include "arete/vtk/image.h"

namespace arete::vtk {

/// One kind of cell of a map.
struct MapClass {
  std::string label;
  Rgb color{};
};

/// One axis of a map: its name and what the centres of its first and last cells stand for.
struct MapAxis {
  std::string name;
  double first = 0;
  double last = 1;
};

/// A region of the plane, drawn as a line around it.
struct MapOutline {
  std::string label;
  Rgb color{};
  /// Negative inside, positive outside, infinities allowed; sampled evenly, row 0 at the bottom,
  /// from the first to the last value of both axes. At least 2 x 2 samples.
  Grid<double> field;
  /// Where given (the same size), only the parts of the line at which it is negative are drawn.
  Grid<double> within{};
};

/// A plane cut into cells, each of one class.
struct ClassMap {
  MapAxis x;
  MapAxis y;                      ///< upwards; without a name: no ticks (a map of one parameter)
  Grid<int> cells;                ///< row 0 at the bottom; indices into classes
  std::vector<MapClass> classes;  ///< those that occur are listed in the legend
  std::vector<MapOutline> outlines{};  ///< those with a line in the map are listed below them
};

/// Draws a map with axes and legend as a PNG, without a display (see offscreen_window.h).
/// \throws InvalidField for no cells, a class number out of range, an outline with NaN. \throws
/// RenderError for a size outside 200 to 8192, without OpenGL. \throws WriteError
void plot_map(const ClassMap& map, std::array<int, 2> size, const std::filesystem::path& png);

}  // namespace arete::vtk
