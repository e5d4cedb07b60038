// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "arete/vtk/image.h"

namespace arete::cli {

/// "#rrggbb", nothing else.
[[nodiscard]] inline std::optional<vtk::Rgb> parse_color(const std::string& text) {
  if (text.size() != 7 || text[0] != '#' ||
      text.find_first_not_of("0123456789abcdefABCDEF", 1) != std::string::npos)
    return std::nullopt;
  vtk::Rgb color;
  for (std::size_t c = 0; c < 3; ++c)
    color[c] = static_cast<std::uint8_t>(std::stoi(text.substr(1 + 2 * c, 2), nullptr, 16));
  return color;
}

}  // namespace arete::cli
