// SPDX-License-Identifier: MIT
#include "arete/vtk/colormap.h"

#include <cmath>

#include "arete/vtk/error.h"

namespace arete::vtk {
namespace {

/// Colours at equal distances.
std::vector<ColorStop> even(std::initializer_list<Rgb> colors) {
  std::vector<ColorStop> stops;
  for (const Rgb& color : colors) {
    stops.push_back(
        {static_cast<double>(stops.size()) / static_cast<double>(colors.size() - 1), color});
  }
  return stops;
}

const std::vector<Colormap>& table() {
  static const std::vector<Colormap> maps{
      {"terrain",
       "hypsometric: green valleys, brown slopes, white tops",
       {{0.00, {74, 116, 84}},
        {0.14, {110, 145, 98}},
        {0.28, {156, 173, 115}},
        {0.42, {205, 200, 143}},
        {0.56, {207, 176, 120}},
        {0.70, {175, 132, 92}},
        {0.84, {150, 118, 100}},
        {0.93, {190, 178, 170}},
        {1.00, {248, 246, 243}}}},
      {"gray", "black to white", even({{40, 40, 40}, {245, 245, 245}})},
      {"viridis", "dark violet to yellow, perceptually even",
       even({{68, 1, 84},
             {72, 36, 117},
             {64, 67, 135},
             {52, 94, 141},
             {41, 120, 142},
             {32, 144, 140},
             {34, 167, 132},
             {68, 190, 112},
             {121, 209, 81},
             {189, 222, 38},
             {253, 231, 37}})},
      {"magma", "black over red to pale yellow, perceptually even",
       even({{0, 0, 4},
             {20, 14, 54},
             {59, 15, 112},
             {100, 26, 128},
             {140, 41, 129},
             {183, 55, 121},
             {222, 73, 104},
             {247, 112, 92},
             {254, 159, 109},
             {254, 207, 146},
             {252, 253, 191}})},
      {"glacier", "slate blue to white",
       even({{44, 62, 84}, {78, 108, 138}, {128, 160, 184}, {186, 206, 220}, {246, 249, 251}})},
      {"clay", "one warm tone: shape by light alone", even({{205, 186, 164}, {222, 206, 188}})},
  };
  return maps;
}

}  // namespace

Rgb Colormap::operator()(double value) const {
  if (!(value > stops.front().at)) return stops.front().color;
  for (std::size_t k = 1; k < stops.size(); ++k) {
    if (value > stops[k].at) continue;
    const ColorStop& low = stops[k - 1];
    const ColorStop& high = stops[k];
    const double t = (value - low.at) / (high.at - low.at);
    Rgb mixed;
    for (std::size_t c = 0; c < 3; ++c) {
      mixed[c] = static_cast<std::uint8_t>(std::lround((1 - t) * low.color[c] + t * high.color[c]));
    }
    return mixed;
  }
  return stops.back().color;
}

std::span<const Colormap> colormaps() { return table(); }

const Colormap& find_colormap(const std::string& name) {
  std::string known;
  for (const Colormap& map : table()) {
    if (map.name == name) return map;
    known += (known.empty() ? "" : ", ") + map.name;
  }
  throw RenderError("there is no colormap '" + name + "'; choose one of: " + known);
}

}  // namespace arete::vtk
