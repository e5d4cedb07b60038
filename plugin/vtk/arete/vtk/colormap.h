// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "arete/vtk/image.h"

namespace arete::vtk {

/// A colour and where on the way from the lowest (0) to the highest value (1) it stands.
struct ColorStop {
  double at = 0;
  Rgb color{};
};

/// Colours for values in [0, 1], linear between its stops.
struct Colormap {
  std::string name;
  std::string meaning;  ///< one line, for a help text
  std::vector<ColorStop> stops;

  /// Values outside take the colour of the nearer end, NaN that of 0.
  [[nodiscard]] Rgb operator()(double value) const;
};

/// All there are; the first is the default.
[[nodiscard]] std::span<const Colormap> colormaps();

/// \throws RenderError for an unknown name; the message lists those there are.
[[nodiscard]] const Colormap& find_colormap(const std::string& name);

}  // namespace arete::vtk
