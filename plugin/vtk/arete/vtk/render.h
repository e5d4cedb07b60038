// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "arete/vtk/appearance.h"
#include "arete/vtk/light.h"
#include "arete/vtk/surface.h"

namespace arete::vtk {

enum class View {
  oblique,  ///< perspective, from `azimuth` and `pitch`
  map,      ///< straight down without perspective, north up: a coloured hillshade
};

struct RenderOptions {
  int width = 1600;
  int height = 1000;
  Appearance appearance{};
  std::vector<Light> lights{Light{}};
  Material material{};
  /// Whether the terrain between a light and the ground keeps the light off it.
  bool shadows = false;
  /// How many times higher than in truth; 0 chooses.
  double exaggeration = 0;
  View view = View::oblique;
  double azimuth = 180;  ///< where the camera stands: degrees clockwise from north
  double pitch = 42;     ///< degrees above the horizon, 1 to 89
  /// How heights become colours, left out under a texture; of a palette, its layers by name.
  bool color_bar = true;
  std::string units = "m";  ///< what the colour bar says the heights are in; may be empty
  Rgb background{255, 255, 255};
  Index most_samples = 2000;  ///< a side that are drawn; more are averaged
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

/// Draws a surface: lit, coloured, on a plain background, as a PNG or JPEG (see write_picture).
/// Needs no display (see offscreen_window.h).
///
/// Holes are quads with a missing corner; the background shows through. Surfaces of more than
/// most_samples a side are averaged down first. The same surface gives the same picture on one
/// machine; other drivers change a few pixels.
/// \throws InvalidField see check_geometry; also when not a single quad is whole.
/// \throws RenderError without OpenGL, for an option out of range (sizes 16 to 8192 pixels,
/// exaggeration not negative), or what check(Appearance), check(Light), check(Material) refuse.
/// \throws WriteError
RenderReport render(const Surface& surface, const RenderOptions& options,
                    const std::filesystem::path& picture);

/// The same from all around: frame k of `frames` stands 360 k / frames degrees clockwise of
/// options.azimuth, all at one distance from the middle, lights standing fast. `path_of` names each
/// frame's file before it is drawn, and may throw to end.
/// \throws RenderError also for less than one frame, and for a map.
RenderReport render_turntable(const Surface& surface, const RenderOptions& options, int frames,
                              const std::function<std::filesystem::path(int frame)>& path_of);

}  // namespace arete::vtk
