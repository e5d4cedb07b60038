// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "arete/vtk/image.h"
#include "arete/vtk/polyline.h"

namespace arete::vtk {

struct PlotOptions {
  int width = 1000;
  int height = 800;
  /// The same scale along both axes; off stretches the curve to fill the picture.
  bool equal_axes = true;
  double line_width = 2.5;  ///< of the curve, in pixels; the control polygon's is half of it
  Rgb curve_color{31, 92, 153};
  Rgb control_color{150, 150, 150};
  Rgb point_color{200, 60, 40};
  Rgb background{255, 255, 255};
};

/// Draws a refined curve over its control polygon and control points as a PNG; of more than two
/// coordinates the first two. Needs no display (see offscreen_window.h). The margin is a twelfth of
/// the shorter side.
/// \throws InvalidField see check_polyline. \throws RenderError for a size outside 16 to 8192, for
/// a line width that is not positive, without OpenGL. \throws WriteError
void plot_curve(const Polyline& curve, const std::optional<Polyline>& control,
                const PlotOptions& options, const std::filesystem::path& png);

}  // namespace arete::vtk
