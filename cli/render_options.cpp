// SPDX-License-Identifier: MIT
#include "cli/render_options.h"

#include <array>
#include <cstdio>
#include <utility>

#include "arete/vtk/error.h"
#include "cli/color.h"
#include "cli/error.h"
#include "cli/palette_json.h"

namespace arete::cli {
namespace {

template <class... Numbers>
bool scans(const std::string& text, const char* form, Numbers*... numbers) {
  int used = 0;
  const int found = std::sscanf(text.c_str(), form, numbers..., &used);
  return found == static_cast<int>(sizeof...(numbers)) &&
         static_cast<std::size_t>(used) == text.size();
}

[[noreturn]] void not_of_form(const char* option, const std::string& text, const char* example) {
  throw Misuse(std::string(option) + " '" + text + "' is not of the form " + example);
}

vtk::Rgb color_of(const char* option, const std::string& text) {
  const auto color = parse_color(text);
  if (!color) throw Misuse(std::string(option) + " '" + text + "' has no colour like #ffe0b0");
  return *color;
}

/// AZIMUTH,ELEVATION[,INTENSITY[,#rrggbb]].
vtk::Light light_from(std::string text) {
  const std::string whole = text;
  vtk::Light light;
  if (const auto hash = text.find(",#"); hash != std::string::npos) {
    light.color = color_of("--light", text.substr(hash + 1));
    text.resize(hash);
  }
  if (!scans(text, "%lf,%lf%n", &light.azimuth, &light.elevation) &&
      !scans(text, "%lf,%lf,%lf%n", &light.azimuth, &light.elevation, &light.intensity))
    not_of_form("--light", whole,
                "315,40 or 315,40,0.8 or 315,40,0.8,#ffe0b0 (azimuth, elevation, intensity, colour)");
  try {
    check(light);
  } catch (const vtk::RenderError& error) {
    throw Misuse("--light " + whole + ": " + error.what());
  }
  return light;
}

vtk::View view_from(const RenderArguments& a, vtk::RenderOptions& options) {
  if (a.view == "map") {
    if (!a.camera.empty()) throw Misuse("--camera: a map is seen from straight above; leave one");
    if (a.turntable > 0) throw Misuse("--turntable: a map does not turn; use another --view");
    return vtk::View::map;
  }
  constexpr std::array<std::pair<const char*, std::array<double, 2>>, 9> presets{
      {{"oblique", {180, 42}},
       {"low", {180, 20}},
       {"high", {180, 65}},
       {"south", {180, 30}},
       {"southwest", {225, 30}},
       {"west", {270, 30}},
       {"north", {0, 30}},
       {"east", {90, 30}},
       {"southeast", {135, 30}}}};
  for (const auto& [name, from] : presets) {
    if (a.view != name) continue;
    options.azimuth = from[0];
    options.pitch = from[1];
  }
  if (!a.camera.empty() && !scans(a.camera, "%lf,%lf%n", &options.azimuth, &options.pitch))
    not_of_form("--camera", a.camera, "210,30 (azimuth, degrees above the horizon)");
  return vtk::View::oblique;
}

}  // namespace

vtk::Appearance appearance_from(const RenderArguments& a) {
  vtk::Appearance look;
  if (!a.colormap.empty() && !a.palette.empty())
    throw Misuse("--colormap and --palette both colour the ground; give one of them");
  if (!a.colormap.empty()) look.colormap = a.colormap;
  if (!a.palette.empty()) look.palette = read_palette(a.palette);
  if (!a.range.empty()) {
    std::array<double, 2> range{};
    if (!scans(a.range, "%lf:%lf%n", &range[0], &range[1]))
      not_of_form("--range", a.range, "200:1800 (heights at both ends of the colours)");
    look.range = range;
  }
  return look;
}

vtk::RenderOptions options_from(const RenderArguments& a) {
  vtk::RenderOptions options;
  if (!scans(a.size, "%dx%d%n", &options.width, &options.height))
    not_of_form("--size", a.size, "1600x1000");
  options.appearance = appearance_from(a);
  if (!a.lights.empty()) options.lights.clear();
  for (const std::string& light : a.lights) options.lights.push_back(light_from(light));
  options.material = a.material;
  options.shadows = a.shadows;
  options.exaggeration = a.exaggerate;
  options.view = view_from(a, options);
  options.color_bar = !a.no_color_bar;
  options.background = color_of("--background", a.background);
  options.most_samples = a.max_samples;
  return options;
}

}  // namespace arete::cli
