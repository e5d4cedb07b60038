// SPDX-License-Identifier: MIT
// arete refine: a coarse raster or mesh in, a fine one (or a VTK file) out.
#include <chrono>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>

#include "arete/analysis/limit_stencil.h"
#include "arete/gdal/refine_raster.h"
#include "arete/parallel/for_each_band.h"
#include "cli/cardinal_stencil.h"
#include "cli/detail_statistics.h"
#include "cli/disk_space.h"
#include "cli/error.h"
#include "cli/interruption.h"
#include "cli/json_number.h"
#include "cli/memory_size.h"
#include "cli/output_file.h"
#include "cli/progress.h"
#include "cli/raster_notes.h"
#include "cli/scheme_json.h"
#include "cli/verb.h"
#ifdef ARETE_HAVE_VTK
#include "cli/refine_surface.h"
#include "cli/render_options.h"
#endif
#ifdef ARETE_HAVE_OPENMESH
#include "cli/refine_mesh.h"
#include "cli/refine_raster_mesh.h"
#endif

namespace arete::cli {
namespace {

struct RefineArguments {
  std::string input;
  std::string output;
  std::string scheme;
  std::string scheme_y;
  int levels = 1;
  std::string boundary = "extrapolate";
  std::string align = "nodes";
  int threads = 0;
  std::string max_memory;
  std::string type;
  std::vector<std::string> creation_options;
  int band = 1;
  std::optional<Index> most_triangles;
  std::string palette;
  std::string texture;
  bool limit = false;
  std::optional<double> roughness;
  std::optional<double> relief;
  std::optional<std::uint64_t> seed;
  bool interpolate = false;
  bool overwrite = false;
  bool json = false;
};

std::string extension_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (extension == ".jpeg") return ".jpg";
  return extension == ".tiff" ? ".tif" : extension;
}

bool is_picture_form(const std::string& form) { return form == ".png" || form == ".jpg"; }

bool is_surface_form(const std::string& form) {
  return form == ".vti" || form == ".vts" || form == ".vtp" || form == ".glb" ||
         is_picture_form(form);
}

bool is_mesh_form(const std::string& form) {
  return form == ".obj" || form == ".ply" || form == ".off" || form == ".stl";
}

void check_form(const std::string& output, const std::string& form) {
  if (form != ".tif" && !is_surface_form(form) && !is_mesh_form(form))
    throw Misuse(output + ": the format '" + form +
                 "' is not one of .tif, .vti, .vts, .vtp, .glb, .obj, .ply, .off, .stl; name the "
                 "output so");
#ifndef ARETE_HAVE_OPENMESH
  if (is_mesh_form(form))
    throw Failure(output + ": this arete was built without OpenMesh; write a .tif or .vtp");
#endif
#ifndef ARETE_HAVE_VTK
  if (is_surface_form(form))
    throw Failure(output + ": this arete was built without VTK; write a .tif");
#endif
}

Stencil limit_of(const Scheme& scheme) {
  const auto stencil = limit_stencil(scheme.mask());
  if (!stencil)
    throw Misuse("--limit: " + scheme.text() +
                 " has no certified limit; leave --limit out or choose a convergent scheme");
  return *stencil;
}

std::optional<Detail> detail_from(const RefineArguments& arguments) {
  if (!arguments.roughness) {
    if (arguments.relief || arguments.seed)
      throw Misuse("--seed and --detail-relief say what --detail ROUGHNESS shall be; give it too");
    return {};
  }
  Detail detail;
  detail.roughness = *arguments.roughness;
  detail.relief = arguments.relief.value_or(detail.relief);
  detail.seed = arguments.seed.value_or(detail.seed);
  return detail;
}

RefineOptions options_from(const RefineArguments& arguments, const Scheme& x, const Scheme& y) {
  RefineOptions options;
  options.levels = arguments.levels;
  options.boundaries = parse_boundaries(arguments.boundary);
  options.alignment = arguments.align == "cells" ? Alignment::cells : Alignment::nodes;
  options.threads = arguments.threads;
  options.detail = detail_from(arguments);
  if (arguments.limit) {
    options.final_x = limit_of(x);
    options.final_y = limit_of(y);
  }
  return options;
}

#ifdef ARETE_HAVE_OPENMESH
void refine_mesh(const RefineArguments& arguments) {
  if (arguments.align != "nodes")
    throw Misuse("--align cells is for rasters; the samples of a mesh are its vertices");
  if (!arguments.creation_options.empty())
    throw Misuse("--creation-option is for GeoTIFF; a mesh file has none");
  if (arguments.roughness || arguments.relief || arguments.seed)
    throw Misuse("--detail is for rasters; a mesh has no heights to displace");
  if (arguments.band != 1) throw Misuse("--band is for rasters; a mesh has no bands");
  if (arguments.most_triangles)
    throw Misuse(
        "--max-triangles is for meshes made of rasters; a refined mesh keeps all its quads");
  if (!arguments.palette.empty() || !arguments.texture.empty())
    throw Misuse("--palette and --texture are for a .glb made of a raster");
  if (arguments.interpolate) throw Misuse("--interpolate is for rasters; leave it out for a mesh");
  MeshJob job{arguments.input, arguments.output, read_scheme(arguments.scheme),
              read_scheme(arguments.scheme_y.empty() ? arguments.scheme : arguments.scheme_y)};
  if (arguments.levels < 0)
    throw Misuse("--levels " + std::to_string(arguments.levels) + " is negative");
  job.options.levels = arguments.levels;
  job.options.boundaries = parse_boundaries(arguments.boundary);
  job.options.threads = arguments.threads;
  job.options.on_limit = arguments.limit;
  job.single_precision = arguments.type == "float32";
  job.max_memory =
      arguments.max_memory.empty() ? default_memory() : parse_memory_size(arguments.max_memory);
  job.overwrite = arguments.overwrite;
  job.json = arguments.json;
  refine_mesh_file(job);
}
#endif

#ifdef ARETE_HAVE_VTK
// The same colours as arete render gives a model.
ModelLook look_from(const RefineArguments& arguments) {
  RenderArguments as_drawn;
  as_drawn.palette = arguments.palette;
  return {appearance_from(as_drawn), arguments.texture};
}
#endif

Json detail_json(const Detail& detail, const DetailStatistics& statistics) {
  return {
      {"roughness", detail.roughness},
      {"relief", detail.relief},
      {"seed", detail.seed},
      {"spectral_slope",
       {{"before", slope_or_null(statistics.before)}, {"after", slope_or_null(statistics.after)}}}};
}

void report_detail(const Detail& detail, const DetailStatistics& statistics) {
  if (!statistics.after) return;
  std::ostringstream line;
  line << std::fixed << std::setprecision(2) << "detail: the power of profiles falls as k^"
       << statistics.after->slope
       << " in the new octaves but the first and last (detail of roughness " << detail.roughness
       << " alone: k^" << -(2 * detail.roughness + 1) << ")";
  if (statistics.before) line << ", in those of the input as k^" << statistics.before->slope;
  std::cout << line.str() << '\n';
}

// What was made of a raster.
struct Done {
  gdal::RasterReport raster;
  DetailStatistics detail;
#ifdef ARETE_HAVE_OPENMESH
  std::optional<RasterMesh> mesh;
#endif
};

#ifdef ARETE_HAVE_OPENMESH
Json mesh_json(const RasterMesh& mesh) {
  return {{"vertices", mesh.vertices},
          {"quads", mesh.quads},
          {"triangles", mesh.triangles},
          {"largest_error", number_or_null(mesh.largest_error)},
          {"left_out", mesh.left_out}};
}

void report_mesh(const RasterMesh& mesh) {
  std::ostringstream line;
  line << "mesh: " << mesh.vertices << " vertices, ";
  if (mesh.triangles == 0)
    line << mesh.quads << " quads";
  else
    line << mesh.triangles << " triangles, at most " << std::setprecision(3) << mesh.largest_error
         << " (in units of the heights) from a refined sample";
  if (mesh.left_out > 0)
    line << "; " << mesh.left_out << " valid samples beside missing ones are in no triangle";
  std::cout << line.str() << '\n';
}
#endif

void report(const RefineArguments& arguments, const Scheme& x, const Scheme& y, const Done& all,
            double seconds) {
  const gdal::RasterReport& done = all.raster;
  const DetailStatistics& statistics = all.detail;
  const double samples =
      static_cast<double>(done.output.rows) * static_cast<double>(done.output.cols) * done.bands;
  const double speed = seconds > 0 ? samples / seconds : 0;
  const int threads = arguments.threads > 0 ? arguments.threads : available_threads();
  if (arguments.json) {
    Json object{{"input", arguments.input}, {"output", arguments.output},
                {"rows", done.output.rows}, {"cols", done.output.cols},
                {"bands", done.bands},      {"levels", arguments.levels},
                {"scheme", x.text()}};
    if (!(x == y)) object["scheme_y"] = y.text();
    object["interpolated"] = arguments.interpolate;
    object["seconds"] = seconds;
    object["samples_per_second"] = speed;
    object["threads"] = threads;
    if (const auto detail = detail_from(arguments))
      object["detail"] = detail_json(*detail, statistics);
    object["misplacement"] = {{"x", done.misplacement_x}, {"y", done.misplacement_y}};
#ifdef ARETE_HAVE_OPENMESH
    if (all.mesh) object["mesh"] = mesh_json(*all.mesh);
#endif
    std::cout << object.dump(2) << '\n';
    return;
  }
  std::ostringstream line;
  line << arguments.input << " (" << done.input.cols << " x " << done.input.rows << ") -> "
       << arguments.output << " (" << done.output.cols << " x " << done.output.rows;
  if (done.bands > 1) line << ", " << done.bands << " bands";
  line << "): " << x.text() << (x == y ? "" : " along x, " + y.text() + " along y") << ", "
       << arguments.levels << (arguments.levels == 1 ? " level" : " levels")
       << (arguments.interpolate ? ", limit through the samples" : "") << std::fixed
       << std::setprecision(2) << ", " << seconds << " s, " << std::setprecision(1) << speed / 1e6
       << " M samples/s";
  std::cout << line.str() << '\n';
#ifdef ARETE_HAVE_OPENMESH
  if (all.mesh) report_mesh(*all.mesh);
#endif
  if (const auto detail = detail_from(arguments)) report_detail(*detail, statistics);
  if (done.misplacement_x != 0 || done.misplacement_y != 0)
    std::cout << "note: this scheme's samples do not fall on the cell centres asked for; they are "
                 "written where they lie, "
              << done.misplacement_x << " (x) and " << done.misplacement_y
              << " (y) input pixels beside them\n";
}

// The type asked for, else one that holds the input's samples as they are.
gdal::SampleType type_from(const RefineArguments& arguments, const gdal::Raster& input) {
  const bool wide =
      arguments.type.empty() ? RasterNotes::of(input).needs_float64 : arguments.type == "float64";
  return wide ? gdal::SampleType::float64 : gdal::SampleType::float32;
}

void refine(const RefineArguments& arguments) {
#ifdef ARETE_HAVE_OPENMESH
  if (openmesh::is_mesh_file(arguments.input)) {
    refine_mesh(arguments);
    return;
  }
#endif
  const std::string form = extension_of(arguments.output);
  check_form(arguments.output, form);
  const Scheme x = read_scheme(arguments.scheme);
  const Scheme y = arguments.scheme_y.empty() ? x : read_scheme(arguments.scheme_y);
  const RefineOptions options = options_from(arguments, x, y);
  const double memory =
      arguments.max_memory.empty() ? default_memory() : parse_memory_size(arguments.max_memory);
  const bool as_mesh =
      is_mesh_form(form) || (arguments.most_triangles && (form == ".vtp" || is_picture_form(form)));
#ifndef ARETE_HAVE_OPENMESH
  if (as_mesh)
    throw Failure(arguments.output +
                  ": this arete was built without OpenMesh; leave --max-triangles out");
#endif
  if (is_picture_form(form) && !as_mesh)
    throw Misuse(arguments.output +
                 ": a picture shows the triangles of --max-triangles; give it, or draw a refined "
                 "raster with 'arete render'");
  if (arguments.interpolate && as_mesh)
    throw Misuse(
        "--interpolate is for rasters and VTK files of all samples; write a .tif, .vti, "
        ".vts, .vtp or .glb without --max-triangles");
  if (arguments.most_triangles && !as_mesh)
    throw Misuse(
        "--max-triangles is for meshes; write a .obj, .ply, .off, .stl or .vtp, "
        "or see them in a .png or .jpg");
  if (form != ".glb" && !(arguments.palette.empty() && arguments.texture.empty()))
    throw Misuse("--palette and --texture are for a textured model; write a .glb");
  std::optional<gdal::LimitWeights> interpolate;
  if (arguments.interpolate) interpolate = {cardinal_stencil(x), cardinal_stencil(y)};

  const gdal::Raster input(arguments.input);
  const auto type = type_from(arguments, input);
  OutputFile output(arguments.output, arguments.input, arguments.overwrite);
  const auto start = std::chrono::steady_clock::now();
  Done done;
  {
    ProgressBar progress("refining");
    if (form == ".tif") {
      const Refiner<float> size(x, y, input.extent(), options);
      check_disk(arguments.output, arguments.creation_options,
                 static_cast<double>(size.output().rows) * static_cast<double>(size.output().cols) *
                     static_cast<double>(input.bands().size()) *
                     (type == gdal::SampleType::float64 ? 8 : 4));
      done.raster = gdal::refine_raster(input, output.temporary().string(), x, y, options,
                                        {type, arguments.creation_options, memory, interpolate},
                                        [&](double share) { progress.show(share); });
    }
#ifdef ARETE_HAVE_OPENMESH
    else if (as_mesh) {
      done.mesh = refine_to_mesh(input, arguments.band, output.temporary(), form.substr(1), x, y,
                                 options, type, arguments.most_triangles, memory, progress);
      done.raster = done.mesh->raster;
      done.detail = done.mesh->detail;
    }
#endif
#ifdef ARETE_HAVE_VTK
    else {
      const RefinedSurface surface =
          refine_to_surface(input, arguments.band, output.temporary(), form, x, y, options, type,
                            memory, look_from(arguments), interpolate, progress);
      done.raster = surface.raster;
      done.detail = surface.detail;
    }
#endif
  }
  stop_if_interrupted();
  if (options.detail && form == ".tif")
    done.detail = detail_statistics(input, gdal::Raster(output.temporary().string()),
                                    std::pow(x.mask().arity(), options.levels));
  output.commit();
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  report(arguments, x, y, done, seconds);
}

}  // namespace

void add_refine(CLI::App& program, Job& job) {
  CLI::App* verb = program.add_subcommand(
      "refine",
      "Refine a raster into a GeoTIFF (.tif), a VTK file (.vti, .vts, .vtp), a textured model\n"
      "(.glb) or a mesh of quads (.obj, .ply, .off, .stl), or a mesh that is a grid into a mesh or "
      "a .vtp");
  auto a = std::make_shared<RefineArguments>();
  verb->add_option("IN", a->input, "Any raster that GDAL reads, or a mesh: .obj, .ply, .off, .stl")
      ->required();
  verb->add_option(
          "OUT", a->output,
          "The format follows the extension: .tif, .vti (heights), .vts or .vtp (geometry), .glb "
          "(textured model), .obj, .ply, .off, .stl")
      ->required();
  verb->add_option("--scheme", a->scheme,
                   "Scheme, e.g. gentle or four-point:omega=1/16 ('arete schemes' lists all)")
      ->required();
  verb->add_option("--scheme-y", a->scheme_y, "Another scheme from row to row");
  verb->add_option("--levels", a->levels, "How many times the grid is refined")
      ->capture_default_str();
  verb->add_option("--boundary", a->boundary,
                   "extrapolate, clamp, reflect, periodic or none; or two of them, x then y")
      ->capture_default_str();
  verb->add_option("--align", a->align,
                   "nodes: between the outermost samples; cells: the same bounding box, cut finer")
      ->check(CLI::IsMember({"nodes", "cells"}))
      ->capture_default_str();
  verb->add_flag("--limit", a->limit, "Put the last level's samples on the limit surface");
  verb->add_option("--detail", a->roughness,
                   "Add random detail of this roughness H: 0 raw to 2 smooth, terrain 0.5 to 0.9")
      ->check(CLI::Range(0.0, 2.0));
  verb->add_option("--seed", a->seed, "Another seed, another surface of the same character (0)");
  verb->add_option("--detail-relief", a->relief,
                   "Height of the detail as a share of the local relief (0.15)")
      ->check(CLI::NonNegativeNumber);
  verb->add_flag("--interpolate", a->interpolate,
                 "Find the control points whose limit passes through the samples, and refine them");
  verb->add_option("--threads", a->threads, "0: as many as the machine has; never changes a bit")
      ->check(CLI::Range(0, 4096))
      ->capture_default_str();
  verb->add_option("--max-memory", a->max_memory,
                   "Memory to hold at most, e.g. 800M (default: half of the machine's)");
  verb->add_option(
          "--type", a->type,
          "Arithmetic and samples of the result (rasters: float32, or float64 where float32 "
          "would not hold the input's; meshes are computed in double, and written so "
          "unless told float32)")
      ->check(CLI::IsMember({"float32", "float64"}));
  verb->add_option("--creation-option", a->creation_options,
                   "KEY=VALUE of GDAL's GTiff driver, may be repeated; the defaults are TILED=YES "
                   "COMPRESS=DEFLATE PREDICTOR=3 BIGTIFF=IF_SAFER")
      ->expected(1)
      ->take_all();
  verb->add_option("--band", a->band, "Which band holds the heights (.tif has all of them)")
      ->capture_default_str();
  verb->add_option("--max-triangles", a->most_triangles,
                   "A mesh of a raster: quads while they make no more triangles than this, else so "
                   "many triangles, placed where the surface needs them")
      ->check(CLI::Range(Index{2}, Index{1'000'000'000}));
  verb->add_option("--palette", a->palette,
                   "Colours of a .glb by height, slope and aspect, as in 'arete render'");
  verb->add_option("--texture", a->texture,
                   "A picture laid over a .glb, by its georeference if it has one");
  verb->add_flag("--overwrite", a->overwrite, "Replace OUT if it exists");
  verb->add_flag("--json", a->json, "Print one JSON object about what was done");
  verb->callback([&job, a] { job = [a] { refine(*a); }; });
}

}  // namespace arete::cli
