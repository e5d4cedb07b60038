// SPDX-License-Identifier: MIT
#pragma once

#include "arete/vtk/palette.h"

class vtkRenderer;

namespace arete::vtk {

/// The layers of a palette by name, the last one on top.
struct PaletteLegend {
  const Palette& palette;
  Rgb ink{};      ///< of text and outlines
  int scale = 1;  ///< drawn pixels per pixel
};

/// How wide the strip of a picture of this height has to be, in its pixels.
[[nodiscard]] int palette_legend_width(const PaletteLegend& legend, int height);

/// Fills a renderer, whose strip is as high as the picture, with the legend.
void draw_palette_legend(const PaletteLegend& legend, int height, vtkRenderer& renderer);

}  // namespace arete::vtk
