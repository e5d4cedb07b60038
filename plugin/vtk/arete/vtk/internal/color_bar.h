// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "arete/vtk/colormap.h"

class vtkRenderer;

namespace arete::vtk {

struct ColorBar {
  double low = 0;
  double high = 1;
  std::string units{};
  Rgb ink{};      ///< of text and outline
  int scale = 1;  ///< drawn pixels per pixel
};

/// How wide the strip of a picture of this height has to be for bar and labels, in its pixels.
[[nodiscard]] int color_bar_width(const ColorBar& bar, int height);

/// Fills a renderer, whose strip is width x height of the picture's pixels, with the bar.
void draw_color_bar(const ColorBar& bar, const Colormap& colors, int width, int height,
                    vtkRenderer& renderer);

}  // namespace arete::vtk
