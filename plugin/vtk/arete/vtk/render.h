// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>

#include "arete/vtk/image.h"
#include "arete/vtk/surface.h"

namespace arete::vtk {

enum class View {
  oblique,  ///< perspective from the south, looking down at the slope of a reading desk
  map,      ///< straight down without perspective, north up: a coloured hillshade
};

struct RenderOptions {
  int width = 1600;
  int height = 1000;
  /// Where the light stands: degrees clockwise from north, and degrees above the horizon.
  double light_azimuth = 315;
  double light_elevation = 40;
  /// How many times higher than in truth; 0 chooses.
  double exaggeration = 0;
  std::string colormap = "terrain";
  /// The heights at both ends of the colormap; the lowest and highest drawn if not given.
  std::optional<std::array<double, 2>> range{};
  View view = View::oblique;
  bool color_bar = true;
  std::string units = "m";  ///< what the colour bar says the heights are in
  Rgb background{255, 255, 255};
  /// A picture laid over the raster's whole box (row 0 at its top) instead of the colours; whatever
  /// VTK reads: PNG, JPEG, TIFF, BMP, PNM. There is no colour bar then.
  std::optional<std::filesystem::path> texture{};
};

/// What was drawn, where the options left it open.
struct RenderReport {
  double exaggeration = 1;
  Index reduction = 1;  ///< samples averaged into one, along each side
  Extent drawn{};       ///< samples after that
  double lowest = 0;    ///< ends of the colour bar
  double highest = 0;
  std::string platform{};  ///< where OpenGL came from: "EGL" or "X"
};

/// Draws a surface: lit, coloured by height, on a plain background, as a PNG. Needs no display (see
/// offscreen_window.h).
///
/// Holes are quads with a missing corner; the background shows through. Surfaces of more than 2000
/// samples a side are averaged down first. The same surface gives the same picture on one machine;
/// other drivers change a few pixels.
/// \throws InvalidField see check_geometry; also when not a single quad is whole.
/// \throws RenderError without OpenGL, for an unknown colormap, an option out of range (sizes 16 to
/// 8192 pixels, light elevation 0 to 90, exaggeration not negative), an unreadable texture.
/// \throws WriteError
RenderReport render(const Surface& surface, const RenderOptions& options,
                    const std::filesystem::path& png);

}  // namespace arete::vtk
