// SPDX-License-Identifier: MIT
#include "arete/vtk/internal/color_bar.h"

#include <vtkRenderer.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "arete/vtk/internal/painter.h"
#include "arete/vtk/internal/ticks.h"

namespace arete::vtk {
namespace {

/// Sizes in pixels of the picture, all following from its height.
struct Layout {
  double font;
  double gap;
  double bar_width;
  double bar_low;
  double bar_high;

  explicit Layout(int height)
      : font(std::clamp(height * 0.022, 10.0, 60.0)),
        gap(font * 0.5),
        bar_width(font * 0.9),
        bar_low(height * 0.24),
        bar_high(height * 0.76) {}
};

std::vector<double> bar_ticks(const ColorBar& bar) {
  return bar.high > bar.low ? ticks(bar.low, bar.high, 6) : std::vector{bar.low};
}

}  // namespace

int color_bar_width(const ColorBar& bar, int height) {
  const Layout layout(height);
  std::size_t longest = bar.units.size();
  for (const std::string& text : tick_labels(bar_ticks(bar)))
    longest = std::max(longest, text.size());
  const double text_width = 0.6 * layout.font * static_cast<double>(longest);
  return static_cast<int>(std::ceil(layout.bar_width + 3 * layout.gap + text_width));
}

void draw_color_bar(const ColorBar& bar, const Colormap& colors, int width, int height,
                    vtkRenderer& renderer) {
  const Layout layout(height);
  Painter paint(renderer, bar.scale, bar.ink);
  const double left = 0;
  const double right = std::min<double>(left + layout.bar_width, width);
  const double length = layout.bar_high - layout.bar_low;

  // The outline is four boxes of its own: which of two overlapping 2-D props VTK shows on top is
  // not to be relied on.
  const double low = layout.bar_low;
  const double high = layout.bar_high;
  std::vector<std::array<double, 4>> boxes{{left, low - 1, right + 2, low},
                                           {left, high, right + 2, high + 1},
                                           {left, low, left + 1, high},
                                           {right + 1, low, right + 2, high}};
  std::vector<Rgb> fills(boxes.size(), bar.ink);
  constexpr int steps = 256;
  for (int k = 0; k < steps; ++k) {
    boxes.push_back(
        {left + 1, low + length * k / steps, right + 1, low + length * (k + 1) / steps});
    fills.push_back(colors((k + 0.5) / steps));
  }
  const std::vector<double> values = bar_ticks(bar);
  const std::vector<std::string> texts = tick_labels(values);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double share = bar.high > bar.low ? (values[k] - bar.low) / (bar.high - bar.low) : 0.5;
    const double y = low + length * share;
    boxes.push_back({right + 2, y - 0.5, right + 2 + layout.gap * 0.6, y + 0.5});
    fills.push_back(bar.ink);
    paint.text(texts[k], right + 2 + layout.gap, y, layout.font, TextPlace::right_middle);
  }
  paint.boxes(boxes, fills);
  if (bar.units.empty()) return;
  paint.text(bar.units, left, layout.bar_high + layout.gap, layout.font, TextPlace::right);
}

}  // namespace arete::vtk
