// SPDX-License-Identifier: MIT
#include "arete/vtk/palette.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "arete/vtk/error.h"

namespace arete::vtk {
namespace {

constexpr Window steep(double from, double fade) { return {from, 90, fade}; }
constexpr Window above(double from, double fade) { return {from, 1e9, fade}; }
constexpr Window below(double to, double fade) { return {-1e9, to, fade}; }

const std::vector<Palette>& table() {
  static const std::vector<Palette> palettes{
      {"alpine",
       "meadows and forest, bare rock where it is steep, snow above",
       true,
       true,
       {{"meadow", {150, 172, 98}},
        {"forest", {88, 122, 72}, 0.85, Window{0.04, 0.4, 0.14}, Window{9, 40, 7}},
        {"grass", {172, 168, 112}, 0.9, Window{0.5, 0.68, 0.14}},
        {"scree", {178, 168, 150}, 0.95, above(0.74, 0.14)},
        {"rock", {140, 130, 120}, 0.95, {}, steep(36, 9)},
        {"snow", {248, 250, 255}, 1, above(0.8, 0.1), below(40, 9)},
        {"shaded snow",
         {240, 246, 255},
         0.9,
         above(0.7, 0.09),
         below(38, 8),
         Window{300, 60, 35}}}},
      {"highland",
       "heath and moor, brown tops, grey rock where it is steep",
       true,
       true,
       {{"moor", {158, 156, 104}},
        {"pasture", {144, 174, 100}, 0.9, below(0.25, 0.15), below(14, 8)},
        {"bracken", {186, 154, 100}, 0.8, Window{0.35, 0.7, 0.15}},
        {"heath", {154, 124, 114}, 0.85, above(0.62, 0.15), below(34, 8)},
        {"rock", {158, 154, 148}, 0.95, {}, steep(38, 9)}}},
      {"desert",
       "sand below, ochre and red rock above and on the steep",
       true,
       true,
       {{"sand", {236, 208, 160}},
        {"gravel", {216, 178, 132}, 0.9, above(0.3, 0.2)},
        {"ochre", {208, 146, 98}, 0.85, Window{0.5, 0.7, 0.1}},
        {"red rock", {180, 108, 76}, 0.9, {}, steep(26, 10)},
        {"dark rock", {132, 96, 80}, 0.9, above(0.72, 0.12), steep(30, 8)}}},
  };
  return palettes;
}

void check_window(const std::string& where, const char* key, const std::optional<Window>& window,
                  bool cyclic) {
  if (!window) return;
  const auto fail = [&](const char* why) {
    throw RenderError("palette, layer '" + where + "', " + key + ": " + why);
  };
  if (!std::isfinite(window->from) || !std::isfinite(window->to) || !std::isfinite(window->fade))
    fail("from, to and fade are finite numbers");
  if (!cyclic && window->from > window->to) fail("'from' is not above 'to'");
  if (window->fade < 0) fail("'fade' is not negative");
}

double smooth(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// 0 to 360.
double turn(double degrees) {
  const double rest = std::fmod(degrees, 360);
  return rest < 0 ? rest + 360 : rest;
}

double aspect_weight(const Window& window, double aspect) {
  if (window.to - window.from >= 360) return 1;
  // Along the circle from the window's beginning; what lies behind its end is near one of both.
  const double length = turn(window.to - window.from);
  const double at = turn(aspect - window.from);
  const double outside = at <= length ? 0 : std::min(at - length, 360 - at);
  return Window{-1, 0, window.fade}.weight(outside);
}

}  // namespace

double Window::weight(double value) const {
  const double outside = std::max({from - value, value - to, 0.0});
  if (outside == 0) return 1;
  return fade > 0 ? smooth(1 - outside / fade) : 0;
}

double PaletteLayer::weight(const Ground& ground) const {
  double result = opacity;
  if (height) result *= height->weight(ground.height);
  if (slope) result *= slope->weight(ground.slope);
  if (aspect) result *= aspect_weight(*aspect, ground.aspect) * smooth(ground.slope / 8);
  return result;
}

Rgb Palette::operator()(const Ground& ground) const {
  std::array<double, 3> mixed{};
  for (const PaletteLayer& layer : layers) {
    const double weight = layer.weight(ground);
    for (std::size_t c = 0; c < 3; ++c) mixed[c] += weight * (layer.color[c] - mixed[c]);
  }
  Rgb color;
  for (std::size_t c = 0; c < 3; ++c)
    color[c] = static_cast<std::uint8_t>(std::lround(std::clamp(mixed[c], 0.0, 255.0)));
  return color;
}

std::span<const Palette> palettes() { return table(); }

const Palette& find_palette(const std::string& name) {
  std::string known;
  for (const Palette& palette : table()) {
    if (palette.name == name) return palette;
    known += (known.empty() ? "" : ", ") + palette.name;
  }
  throw RenderError("there is no palette '" + name + "'; choose one of: " + known +
                    "; or give a .json file");
}

void check(const Palette& palette) {
  if (palette.layers.empty()) throw RenderError("a palette needs at least one layer");
  for (const PaletteLayer& layer : palette.layers) {
    if (!(layer.opacity >= 0 && layer.opacity <= 1))
      throw RenderError("palette, layer '" + layer.name + "': opacity is a number from 0 to 1");
    check_window(layer.name, "height", layer.height, false);
    check_window(layer.name, "slope", layer.slope, false);
    check_window(layer.name, "aspect", layer.aspect, true);
  }
}

}  // namespace arete::vtk
