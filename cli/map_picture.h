// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "arete/analysis/smoothness_map.h"
#include "cli/map_outlines.h"

namespace arete::cli {

struct MapPicture {
  const MapRange& x;
  const MapRange& y;
  const std::vector<MapCell>& cells;
  const std::vector<PrintedRegion>& regions;
  /// The exponent's lower bound instead of the order: as colours, over one parameter as a graph.
  bool hoelder = false;
};

/// `1000x800`; an empty text gives the default, which is low for a map of one parameter.
/// \throws Misuse
[[nodiscard]] std::array<int, 2> picture_size(const std::string& text, const MapRange& y);

void draw_map_picture(const MapPicture& picture, std::array<int, 2> size,
                      const std::filesystem::path& png);

}  // namespace arete::cli
