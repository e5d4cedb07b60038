// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "arete/vtk/render.h"

namespace arete::cli {

/// What `arete render` was told, as it was written.
struct RenderArguments {
  std::string input;
  std::string output;
  std::string scheme;
  int levels = 1;
  int band = 1;
  std::string colormap;
  std::string palette;
  std::string range;
  std::string texture;
  bool stretch = false;
  std::vector<std::string> lights;
  bool shadows = false;
  vtk::Material material{};
  double exaggerate = 0;
  std::string view = "oblique";
  std::string camera;
  int turntable = 0;
  std::string size = "1600x1000";
  std::string background = "#ffffff";
  Index max_samples = 2000;
  bool no_color_bar = false;
  std::string units;  ///< of the heights; empty for what the band says
  bool overwrite = false;
  bool json = false;
};

/// Colours but for the texture. \throws Misuse, Failure
[[nodiscard]] vtk::Appearance appearance_from(const RenderArguments& arguments);

/// All of a picture's options but for the texture and the units. \throws Misuse, Failure
[[nodiscard]] vtk::RenderOptions options_from(const RenderArguments& arguments);

}  // namespace arete::cli
