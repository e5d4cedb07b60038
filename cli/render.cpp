// SPDX-License-Identifier: MIT
// arete render: a lit, coloured picture of a raster.
#include "arete/vtk/render.h"

#include <cstdio>
#include <iostream>
#include <memory>

#include "arete/gdal/reduced_band.h"
#include "arete/vtk/colormap.h"
#include "cli/error.h"
#include "cli/find_band.h"
#include "cli/interruption.h"
#include "cli/output_file.h"
#include "cli/raster_surface.h"
#include "cli/scheme_json.h"
#include "cli/verb.h"

namespace arete::cli {
namespace {

struct RenderArguments {
  std::string input;
  std::string output;
  std::string size = "1600x1000";
  std::string light = "315,40";
  double exaggerate = 0;
  std::string colormap;
  std::string texture;
  std::string view = "oblique";
  int band = 1;
  bool no_color_bar = false;
  bool overwrite = false;
  bool json = false;
};

template <class... Numbers>
void scan(const std::string& text, const char* option, const char* form, const char* example,
          Numbers*... numbers) {
  int used = 0;
  const int found = std::sscanf(text.c_str(), form, numbers..., &used);
  if (found != sizeof...(numbers) || static_cast<std::size_t>(used) != text.size())
    throw Misuse(std::string(option) + " '" + text + "' is not of the form " + example);
}

vtk::RenderOptions options_from(const RenderArguments& a, const gdal::BandInfo& band) {
  vtk::RenderOptions options;
  scan(a.size, "--size", "%dx%d%n", "1600x1000", &options.width, &options.height);
  scan(a.light, "--light", "%lf,%lf%n", "315,40 (azimuth, elevation)", &options.light_azimuth,
       &options.light_elevation);
  options.exaggeration = a.exaggerate;
  if (!a.colormap.empty()) options.colormap = a.colormap;
  if (!a.texture.empty()) options.texture = a.texture;
  options.view = a.view == "map" ? vtk::View::map : vtk::View::oblique;
  options.color_bar = !a.no_color_bar;
  if (!band.unit.empty()) options.units = band.unit;
  return options;
}

void render(const RenderArguments& a) {
  if (std::filesystem::path(a.output).extension() != ".png")
    throw Misuse(a.output + ": a picture is a .png; name the output so");
  const gdal::Raster raster(a.input);
  const gdal::BandInfo& band = find_band(raster, a.band);
  const vtk::RenderOptions options = options_from(a, band);
  OutputFile output(a.output, a.input, a.overwrite);
  constexpr Index largest_side = 4000;
  const gdal::ReducedBand reduced = gdal::read_reduced_band(raster, band, largest_side);
  stop_if_interrupted();
  const vtk::Surface surface =
      raster_surface<float>(raster, reduced.georeference, reduced.samples.view());
  const vtk::RenderReport done = vtk::render(surface, options, output.temporary());
  stop_if_interrupted();
  output.commit();
  const Index factor = reduced.factor * done.reduction;
  if (a.json)
    std::cout << Json{{"input", a.input},
                      {"output", a.output},
                      {"width", options.width},
                      {"height", options.height},
                      {"rows_drawn", done.drawn.rows},
                      {"cols_drawn", done.drawn.cols},
                      {"averaged", factor},
                      {"exaggeration", done.exaggeration},
                      {"lowest", done.lowest},
                      {"highest", done.highest}}
                     .dump(2)
              << '\n';
  else
    std::cout << a.input << " -> " << a.output << ": " << done.drawn.cols << " x "
              << done.drawn.rows << " samples drawn"
              << (factor > 1 ? " (each the mean of " + std::to_string(factor) + " x " +
                                   std::to_string(factor) + ")"
                             : "")
              << ", heights " << done.lowest << " .. " << done.highest << " " << options.units
              << ", exaggerated " << done.exaggeration << " times\n";
}

std::string colormap_names() {
  std::string names;
  for (const vtk::Colormap& map : vtk::colormaps()) names += (names.empty() ? "" : ", ") + map.name;
  return names;
}

}  // namespace

void add_render(CLI::App& program, Job& job) {
  CLI::App* verb = program.add_subcommand("render", "Draw a raster as a lit picture (.png)");
  auto a = std::make_shared<RenderArguments>();
  verb->add_option("IN", a->input, "Any raster that GDAL reads")->required();
  verb->add_option("OUT", a->output, "A .png")->required();
  verb->add_option("--size", a->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
  verb->add_option("--light", a->light,
                   "AZIMUTH,ELEVATION of the light in degrees, clockwise from north")
      ->capture_default_str();
  verb->add_option("--exaggerate", a->exaggerate,
                   "How many times higher than in truth (default: chosen from the relief)")
      ->check(CLI::NonNegativeNumber);
  verb->add_option("--colormap", a->colormap, "Colours by height: " + colormap_names());
  verb->add_option("--texture", a->texture, "An image laid over the raster instead of colours");
  verb->add_option("--view", a->view, "oblique (perspective from the south) or map (from above)")
      ->check(CLI::IsMember({"oblique", "map"}))
      ->capture_default_str();
  verb->add_option("--band", a->band, "Which band holds the heights")->capture_default_str();
  verb->add_flag("--no-color-bar", a->no_color_bar, "Leave the colour bar out");
  verb->add_flag("--overwrite", a->overwrite, "Replace OUT if it exists");
  verb->add_flag("--json", a->json, "Print one JSON object about what was done");
  verb->callback([&job, a] { job = [a] { render(*a); }; });
}

}  // namespace arete::cli
