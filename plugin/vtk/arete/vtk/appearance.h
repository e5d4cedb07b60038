// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "arete/vtk/image.h"
#include "arete/vtk/palette.h"

namespace arete::vtk {

/// A picture laid over the surface's whole box, half a sample wider than its samples on each side:
/// its first row along row 0, its first column along column 0.
struct Texture {
  Image image;
  /// 0 (not there) to 255, one a pixel; empty: there everywhere. Where it is not, the colours of
  /// palette or colormap show.
  std::vector<std::uint8_t> opacity{};
};

/// What a surface's ground looks like, before any light.
struct Appearance {
  std::string colormap = "terrain";
  /// The heights at both ends of the colormap, and 0 and 1 of a palette; the lowest and highest
  /// drawn if not given.
  std::optional<std::array<double, 2>> range{};
  std::optional<Palette> palette{};  ///< instead of the colormap
  std::optional<Texture> texture{};  ///< over either
};

/// \throws RenderError for an unknown colormap, a palette that check() refuses, a range that does
/// not run upwards, a texture that is empty or not of the size it says.
void check(const Appearance& appearance);

}  // namespace arete::vtk
