// SPDX-License-Identifier: MIT
// arete render: a raster in, lit pictures or a textured model out.
#include "arete/vtk/render.h"

#include <cctype>
#include <cstdio>
#include <iostream>
#include <memory>

#include "arete/vtk/colormap.h"
#include "arete/vtk/palette.h"
#include "arete/vtk/write_model.h"
#include "cli/drape.h"
#include "cli/error.h"
#include "cli/find_band.h"
#include "cli/interruption.h"
#include "cli/output_set.h"
#include "cli/render_options.h"
#include "cli/rendered_surface.h"
#include "cli/scheme_json.h"
#include "cli/verb.h"

namespace arete::cli {
namespace {

namespace fs = std::filesystem;

std::string form_of(const std::string& output) {
  std::string form = fs::path(output).extension().string();
  for (char& c : form) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (form == ".jpeg") form = ".jpg";
  if (form != ".png" && form != ".jpg" && form != ".glb" && form != ".obj")
    throw Misuse(output +
                 ": a picture is a .png or .jpg, a model a .glb or .obj; name the output "
                 "so");
  return form;
}

/// name.png -> name-007.png.
std::string frame_path(const fs::path& output, int frame) {
  char number[16];
  std::snprintf(number, sizeof number, "-%03d", frame);
  return output.parent_path() / (output.stem().string() + number + output.extension().string());
}

std::string beside(const fs::path& output, const char* extension) {
  return fs::path(output).replace_extension(extension);
}

/// What an OBJ may call the files beside it: many readers end a name at a blank.
void check_name_for_obj(const fs::path& output) {
  for (const char c : output.stem().string())
    if (std::isspace(static_cast<unsigned char>(c)) != 0)
      throw Misuse(output.string() +
                   ": an .obj names the files beside it without blanks; name the output so");
}

struct Loaded {
  const RenderArguments& arguments;
  gdal::Raster raster;
  const gdal::BandInfo& band;
  std::unique_ptr<RenderedSurface> rendered;

  explicit Loaded(const RenderArguments& a)
      : arguments(a), raster(a.input), band(find_band(raster, a.band)) {
    if (a.scheme.empty()) {
      constexpr Index largest_side = 4000;
      rendered = std::make_unique<RenderedSurface>(raster, band, largest_side);
    } else {
      ProgressBar progress("refining");
      rendered = std::make_unique<RenderedSurface>(raster, band, read_scheme(a.scheme), a.levels,
                                                   progress);
    }
    stop_if_interrupted();
  }
  // Nothing where neither the option nor the band says it: heights are often in feet.
  [[nodiscard]] std::string unit() const {
    return arguments.units.empty() ? band.unit : arguments.units;
  }
  [[nodiscard]] vtk::Surface surface() const {
    vtk::Surface surface = rendered->surface();
    if (!arguments.scheme.empty())
      surface.notes = {{"arete_scheme", arguments.scheme},
                       {"arete_levels", std::to_string(arguments.levels)}};
    return surface;
  }
  void lay_texture(vtk::Appearance& look, const vtk::Surface& surface) const {
    if (arguments.texture.empty()) return;
    look.texture =
        drape(arguments.texture, raster, surface.georeference, surface.extent(), arguments.stretch);
  }
};

std::string averaged_text(Index factor) {
  if (factor == 1) return "";
  const std::string side = std::to_string(factor);
  return " (each the mean of " + side + " x " + side + ")";
}

void picture(const RenderArguments& a) {
  vtk::RenderOptions options = options_from(a);
  OutputSet outputs(a.input, a.overwrite);
  std::vector<fs::path> frames;
  for (int k = 0; k < a.turntable; ++k) frames.push_back(outputs.add(frame_path(a.output, k)));
  if (frames.empty()) frames.push_back(outputs.add(a.output));
  const Loaded loaded(a);
  options.units = loaded.unit();
  const vtk::Surface surface = loaded.surface();
  loaded.lay_texture(options.appearance, surface);
  vtk::RenderReport done;
  if (a.turntable > 0) {
    ProgressBar progress("drawing");
    done = vtk::render_turntable(surface, options, a.turntable, [&](int frame) {
      progress.show(static_cast<double>(frame) / a.turntable);
      return frames[static_cast<std::size_t>(frame)];
    });
  } else {
    done = vtk::render(surface, options, frames.front());
  }
  stop_if_interrupted();
  outputs.commit();
  const Index factor = loaded.rendered->factor() * done.reduction;
  const std::string output =
      a.turntable > 0 ? frame_path(a.output, 0) + " .. " + frame_path(a.output, a.turntable - 1)
                      : a.output;
  if (a.json) {
    std::cout << Json{{"input", a.input},
                      {"output", a.output},
                      {"frames", std::max(a.turntable, 1)},
                      {"width", options.width},
                      {"height", options.height},
                      {"rows_drawn", done.drawn.rows},
                      {"cols_drawn", done.drawn.cols},
                      {"averaged", factor},
                      {"exaggeration", done.exaggeration},
                      {"lowest", done.lowest},
                      {"highest", done.highest},
                      {"units", options.units}}
                     .dump(2)
              << '\n';
  } else {
    std::cout << a.input << " -> " << output << ": " << done.drawn.cols << " x " << done.drawn.rows
              << " samples drawn" << averaged_text(factor) << ", heights " << done.lowest << " .. "
              << done.highest << (options.units.empty() ? "" : " ") << options.units
              << ", exaggerated " << done.exaggeration << " times\n";
  }
}

void model(const RenderArguments& a, const std::string& form) {
  vtk::ModelOptions options;
  options.appearance = appearance_from(a);
  if (a.exaggerate > 0) options.exaggeration = a.exaggerate;
  options.most_samples = a.max_samples;
  options.name = fs::path(a.output).stem().string();
  if (form == ".obj") check_name_for_obj(a.output);
  OutputSet outputs(a.input, a.overwrite);
  const fs::path first = outputs.add(a.output);
  vtk::ObjFiles files{first, {}, {}, {}, {}};
  if (form == ".obj") {
    files.mtl = outputs.add(beside(a.output, ".mtl"));
    files.texture = outputs.add(beside(a.output, ".png"));
    files.mtl_name = fs::path(beside(a.output, ".mtl")).filename().string();
    files.texture_name = fs::path(beside(a.output, ".png")).filename().string();
  }
  const Loaded loaded(a);
  const vtk::Surface surface = loaded.surface();
  loaded.lay_texture(options.appearance, surface);
  const vtk::ModelReport done = form == ".glb" ? vtk::write_glb(surface, options, first)
                                               : vtk::write_obj(surface, options, files);
  stop_if_interrupted();
  outputs.commit();
  const Index factor = loaded.rendered->factor() * done.reduction;
  if (a.json) {
    std::cout << Json{{"input", a.input},
                      {"output", a.output},
                      {"vertices", done.vertices},
                      {"quads", done.quads},
                      {"rows_written", done.written.rows},
                      {"cols_written", done.written.cols},
                      {"averaged", factor},
                      {"exaggeration", options.exaggeration},
                      {"texture", {{"width", done.texture_width}, {"height", done.texture_height}}},
                      {"origin", done.origin},
                      {"lowest", done.lowest},
                      {"highest", done.highest}}
                     .dump(2)
              << '\n';
  } else {
    std::cout << a.input << " -> " << a.output;
    if (form == ".obj")
      std::cout << " (with " << files.mtl_name << ", " << files.texture_name << ")";
    std::cout << ": " << done.vertices << " vertices, " << done.quads << " quads"
              << averaged_text(factor) << ", texture " << done.texture_width << " x "
              << done.texture_height << ", exaggerated " << options.exaggeration << " times\n";
  }
}

void render(const RenderArguments& a) {
  const std::string form = form_of(a.output);
  if (form == ".png" || form == ".jpg") return picture(a);
  if (a.turntable > 0) throw Misuse("--turntable makes pictures; name a .png or .jpg");
  model(a, form);
}

template <class Things>
std::string names(const Things& things) {
  std::string text;
  for (const auto& thing : things) text += (text.empty() ? "" : ", ") + thing.name;
  return text;
}

void add_colour_options(CLI::App& verb, RenderArguments& a) {
  verb.add_option("--colormap", a.colormap, "Colours by height: " + names(vtk::colormaps()))
      ->group("Ground");
  verb.add_option(
          "--palette", a.palette,
          "Colours by height, slope and aspect: " + names(vtk::palettes()) + ", or a FILE.json")
      ->group("Ground");
  verb.add_option("--range", a.range, "LOW:HIGH, the heights at both ends of the colours")
      ->group("Ground");
  verb.add_option("--texture", a.texture,
                  "A picture laid over the ground, by its georeference if it has one")
      ->group("Ground");
  verb.add_flag("--stretch", a.stretch, "Lay the texture over the whole raster all the same")
      ->group("Ground");
}

void add_light_options(CLI::App& verb, RenderArguments& a) {
  verb.add_option("--light", a.lights,
                  "AZIMUTH,ELEVATION[,INTENSITY[,#rrggbb]]: degrees clockwise from north and above "
                  "the horizon; may be repeated (default: 315,40)")
      ->expected(1)
      ->take_all()
      ->group("Light");
  verb.add_flag("--shadows", a.shadows, "Mountains keep the light off what lies behind them")
      ->group("Light");
  const auto share = [&](const char* name, double& value, const char* what) {
    verb.add_option(name, value, what)
        ->check(CLI::Range(0.0, 1.0))
        ->capture_default_str()
        ->group("Light");
  };
  share("--ambient", a.material.ambient, "Share of light that comes from nowhere in particular");
  share("--diffuse", a.material.diffuse, "Share of the lights' own that the ground gives back");
  share("--specular", a.material.specular, "Share of it in highlights");
}

void add_view_options(CLI::App& verb, RenderArguments& a) {
  verb.add_option("--view", a.view,
                  "oblique, low, high (from the south), south, southwest, west, north, east, "
                  "southeast (from there), or map (from above)")
      ->check(CLI::IsMember({"oblique", "low", "high", "south", "southwest", "west", "north",
                             "east", "southeast", "map"}))
      ->capture_default_str()
      ->group("View");
  verb.add_option("--camera", a.camera, "AZIMUTH,ELEVATION of the camera, instead of --view")
      ->group("View");
  verb.add_option("--turntable", a.turntable,
                  "So many pictures from all around: OUT-000.png, OUT-001.png, ...")
      ->check(CLI::Range(1, 999))
      ->group("View");
  verb.add_option("--exaggerate", a.exaggerate,
                  "How many times higher than in truth (default: chosen from the relief; 1 for a "
                  "model)")
      ->check(CLI::NonNegativeNumber)
      ->group("View");
  verb.add_option("--size", a.size, "WIDTHxHEIGHT in pixels")->capture_default_str()->group("View");
  verb.add_option("--background", a.background, "#rrggbb")->capture_default_str()->group("View");
  verb.add_flag("--no-color-bar", a.no_color_bar, "Leave colour bar or legend out")->group("View");
  verb.add_option("--units", a.units,
                  "What the colour bar says the heights are in, as m or ft (default: what the "
                  "raster says, or nothing)")
      ->group("View");
}

}  // namespace

void add_render(CLI::App& program, Job& job) {
  CLI::App* verb = program.add_subcommand(
      "render", "Draw a raster as a lit picture (.png .jpg), or make a model of it (.glb .obj)");
  auto a = std::make_shared<RenderArguments>();
  verb->add_option("IN", a->input, "Any raster that GDAL reads")->required();
  verb->add_option("OUT", a->output,
                   "A picture (.png, .jpg), or a textured model (.glb, or .obj with .mtl and .png)")
      ->required();
  auto* scheme = verb->add_option("--scheme", a->scheme,
                                  "Refine first, and shade by the limit surface's own tangents");
  verb->add_option("--levels", a->levels, "How many times it is refined")
      ->needs(scheme)
      ->check(CLI::Range(0, 12))
      ->capture_default_str();
  add_colour_options(*verb, *a);
  add_light_options(*verb, *a);
  add_view_options(*verb, *a);
  verb->add_option("--band", a->band, "Which band holds the heights")->capture_default_str();
  verb->add_option("--max-samples", a->max_samples,
                   "Samples a side that are shown; more are averaged")
      ->check(CLI::Range(2, 20000))
      ->capture_default_str();
  verb->add_flag("--overwrite", a->overwrite, "Replace OUT if it exists");
  verb->add_flag("--json", a->json, "Print one JSON object about what was done");
  verb->callback([&job, a] { job = [a] { render(*a); }; });
}

}  // namespace arete::cli
