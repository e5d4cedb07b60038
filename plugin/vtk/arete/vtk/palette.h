// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "arete/vtk/image.h"

namespace arete::vtk {

/// A range of a quantity with soft edges: weight 1 from `from` to `to`, falling smoothly to 0 over
/// `fade` outside.
struct Window {
  double from = 0;
  double to = 0;
  double fade = 0;

  [[nodiscard]] double weight(double value) const;
};

/// What a palette knows of a sample.
struct Ground {
  double height = 0;  ///< share of the relief from 0 to 1, or in the heights' own units
  double slope = 0;   ///< degrees from level
  double aspect = 0;  ///< degrees clockwise from north that the ground faces; any on level ground
};

/// One colour and where it lies. Without any window it lies everywhere.
struct PaletteLayer {
  std::string name;
  Rgb color{};
  double opacity = 1;  ///< 0 to 1, where all windows have weight 1
  std::optional<Window> height{};
  std::optional<Window> slope{};
  /// From `from` clockwise to `to`, through north if from > to. Ground of less than 8 degrees faces
  /// nowhere in particular: the weight falls to 0 towards level ground.
  std::optional<Window> aspect{};

  /// How much of it lies there, 0 to 1.
  [[nodiscard]] double weight(const Ground& ground) const;
};

/// Colours by height, slope and aspect: rock, grass, snow. Layers are painted in order, each over
/// what lies below.
struct Palette {
  std::string name;
  std::string meaning;  ///< one line, for a help text
  /// Heights of the windows are shares of the relief (0 lowest, 1 highest) or heights themselves.
  bool relative_heights = true;
  /// Slopes of the windows are those drawn, after exaggeration, or those of the terrain.
  bool drawn_slopes = true;
  std::vector<PaletteLayer> layers;

  [[nodiscard]] Rgb operator()(const Ground& ground) const;
};

/// Those there are by name.
[[nodiscard]] std::span<const Palette> palettes();

/// \throws RenderError for an unknown name; the message lists those there are.
[[nodiscard]] const Palette& find_palette(const std::string& name);

/// \throws RenderError without layers, and for a layer whose numbers are not finite, whose window
/// ends before it begins, whose fade is negative or whose opacity is not within 0 and 1.
void check(const Palette& palette);

}  // namespace arete::vtk
