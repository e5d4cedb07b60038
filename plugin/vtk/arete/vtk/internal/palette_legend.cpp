// SPDX-License-Identifier: MIT
#include "arete/vtk/internal/palette_legend.h"

#include <vtkRenderer.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "arete/vtk/internal/painter.h"

namespace arete::vtk {
namespace {

/// Sizes in pixels of the picture, all following from its height and the number of layers.
struct Layout {
  double font;
  double box;
  double step;

  Layout(int height, std::size_t layers)
      : font(std::clamp(height * 0.022, 10.0, 60.0)), box(font), step(font * 1.7) {
    const double room = height * 0.9 / static_cast<double>(std::max<std::size_t>(layers, 1));
    if (step <= room) return;
    font *= room / step;
    box *= room / step;
    step = room;
  }
};

}  // namespace

int palette_legend_width(const PaletteLegend& legend, int height) {
  const Layout layout(height, legend.palette.layers.size());
  std::size_t longest = 0;
  for (const PaletteLayer& layer : legend.palette.layers)
    longest = std::max(longest, layer.name.size());
  return static_cast<int>(
      std::ceil(layout.box + layout.font * (1.2 + 0.6 * static_cast<double>(longest))));
}

void draw_palette_legend(const PaletteLegend& legend, int height, vtkRenderer& renderer) {
  const auto& layers = legend.palette.layers;
  const Layout layout(height, layers.size());
  Painter paint(renderer, legend.scale, legend.ink);
  std::vector<std::array<double, 4>> boxes;
  std::vector<Rgb> fills;
  double low = height / 2.0 - layout.step * static_cast<double>(layers.size()) / 2;
  for (const PaletteLayer& layer : layers) {
    const double high = low + layout.box;
    const double right = layout.box;
    // The outline as boxes of its own, see color_bar.cpp.
    boxes.insert(boxes.end(), {{0, low, right, low + 1},
                               {0, high - 1, right, high},
                               {0, low + 1, 1, high - 1},
                               {right - 1, low + 1, right, high - 1},
                               {1, low + 1, right - 1, high - 1}});
    fills.insert(fills.end(), 4, legend.ink);
    fills.push_back(layer.color);
    paint.text(layer.name, right + layout.font * 0.5, (low + high) / 2, layout.font,
               TextPlace::right_middle);
    low += layout.step;
  }
  paint.boxes(boxes, fills);
}

}  // namespace arete::vtk
