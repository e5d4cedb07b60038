// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "arete/field/grid.h"

namespace arete::vtk {

/// One function, as points of its graph.
struct FunctionGraph {
  std::string label;
  Grid<double> points;  ///< rows (x, y), x ascending
};

/// Draws functions of one variable one above the other over a common x axis, the first on top, each
/// with its own labelled y axis and its line y = 0, as a PNG, without a display (see
/// offscreen_window.h).
/// \throws InvalidField for no graph, a graph of fewer than 2 points, or numbers that are not
/// finite. \throws RenderError for a size outside 200 to 2048, for more than 8 graphs, without
/// OpenGL. \throws WriteError
void plot_functions(const std::vector<FunctionGraph>& graphs, const std::string& x_name,
                    std::array<int, 2> size, const std::filesystem::path& png);

}  // namespace arete::vtk
