// SPDX-License-Identifier: MIT
// arete coarsen: a raster or mesh taken apart into a coarse one and a details file.
#include <chrono>
#include <cmath>
#include <iostream>
#include <memory>
#include <optional>

#include "arete/gdal/band_source.h"
#include "arete/reverse/threshold.h"
#include "cli/details_store.h"
#include "cli/error.h"
#include "cli/interruption.h"
#include "cli/memory_size.h"
#include "cli/output_file.h"
#include "cli/progress.h"
#include "cli/raster_notes.h"
#include "cli/scheme_json.h"
#include "cli/verb.h"
#ifdef ARETE_HAVE_OPENMESH
#include "arete/openmesh/mesh_io.h"
#include "cli/coarsen_mesh.h"
#endif

namespace arete::cli {
namespace {

struct CoarsenArguments {
  std::string input;
  std::string output;
  std::string details;
  std::string scheme;
  std::string rim;
  int levels = 1;
  std::string mode = "least-squares";
  std::string boundary = "extrapolate";
  bool boundary_given = false;
  std::optional<double> threshold;
  std::optional<double> target_rmse;
  int threads = 1;
  std::string max_memory;
  std::string type = "float64";
  bool overwrite = false;
  bool json = false;
  std::string raster_option;  // the first one given that says nothing to a mesh
};

struct Summary {
  DetailCount count;
  double threshold = 0;
  RestoreError error;
  std::size_t bytes = 0;
};

void check_thinning(const CoarsenArguments& a) {
  if (a.details.empty() && (a.threshold || a.target_rmse))
    throw Misuse("--threshold and --target-rmse say which details to keep; give --details FILE");
  if (a.threshold && a.target_rmse)
    throw Misuse("--threshold and --target-rmse exclude each other; give one of them");
  const double allowed = a.threshold.value_or(a.target_rmse.value_or(0));
  if (!(allowed >= 0) || !std::isfinite(allowed))
    throw Misuse("a threshold or target RMSE of " + std::to_string(allowed) +
                 " is impossible; give 0 or more, in units of the heights");
  if (!a.details.empty() &&
      std::filesystem::weakly_canonical(a.details) == std::filesystem::weakly_canonical(a.output))
    throw Misuse("--details names the coarse output itself; name another file");
}

void check_raster_arguments(const CoarsenArguments& a) {
  const std::string form = std::filesystem::path(a.output).extension().string();
  if (form != ".tif" && form != ".tiff")
    throw Misuse(a.output + ": the coarse raster is a GeoTIFF; name it .tif");
  if (!a.rim.empty()) throw Misuse("--rim is for meshes; rasters have --boundary");
}

// Coarse samples as the file will hold them, so that details fit what is read back.
void round_to(gdal::SampleType type, Grid<double>& samples) {
  if (type == gdal::SampleType::float64) return;
  for (double& value : samples.samples()) value = static_cast<double>(static_cast<float>(value));
}

struct Work {
  const CoarsenArguments& a;
  Scheme scheme;
  GridReverseOptions options;
  gdal::SampleType type;
  GridPyramid pyramid;

  // One band; its details go to `file`, its coarse samples are returned.
  Grid<double> coarsen_band(Grid<double> samples, ValidSamples& coarse_valid, DetailsFile& file,
                            Summary& summary) const {
    BandDetails band;
    band.valid = fill_missing(samples.view());
    coarse_valid = coarsened(band.valid, pyramid, options.levels);
    auto parts = decompose_grid<double>(samples.view(), scheme, options);
    stop_if_interrupted();
    round_to(type, parts.coarse);
    if (a.details.empty()) return std::move(parts.coarse);
    double threshold = a.threshold.value_or(0);
    if (a.target_rmse)
      threshold =
          threshold_for_rmse(parts, samples.view(), band.valid, scheme, options, *a.target_rmse);
    if (file.lossy) drop_details(parts, threshold);
    stop_if_interrupted();
    const DetailCount count = count_details(parts);
    summary.count.all += count.all;
    summary.count.kept += count.kept;
    summary.threshold = std::max(summary.threshold, threshold);
    const RestoreError error =
        restore_error(reconstruct_grid(parts, samples.extent(), scheme, options, options.levels),
                      samples.view(), band.valid);
    summary.error.rmse = std::max(summary.error.rmse, error.rmse);
    summary.error.largest = std::max(summary.error.largest, error.largest);
    for (std::size_t i = 0; i < coarse_valid.size(); ++i)
      if (coarse_valid[i] == 0) band.hidden.push_back(parts.coarse.samples()[i]);
    band.coarse_checksum = checksum(parts.coarse.samples());
    band.details = std::move(parts.details);
    file.bands.push_back(std::move(band));
    return std::move(parts.coarse);
  }
};

Json report_json(const CoarsenArguments& a, const Work& work, const Summary& summary,
                 std::size_t bands, double seconds) {
  const Extent fine = work.pyramid.extent(0);
  const Extent coarse = work.pyramid.extent(a.levels);
  Json object{{"input", a.input},
              {"output", a.output},
              {"rows", fine.rows},
              {"cols", fine.cols},
              {"coarse_rows", coarse.rows},
              {"coarse_cols", coarse.cols},
              {"bands", bands},
              {"levels", a.levels},
              {"scheme", work.scheme.text()},
              {"mode", std::string(to_string(work.options.mode))},
              {"seconds", seconds}};
  if (a.details.empty()) return object;
  object["details"] = a.details;
  object["details_bytes"] = summary.bytes;
  object["details_all"] = summary.count.all;
  object["details_kept"] = summary.count.kept;
  object["threshold"] = summary.threshold;
  object["rmse"] = summary.error.rmse;
  object["max_error"] = summary.error.largest;
  return object;
}

void report(const CoarsenArguments& a, const Work& work, const Summary& summary, std::size_t bands,
            double seconds) {
  if (a.json) {
    std::cout << report_json(a, work, summary, bands, seconds).dump(2) << '\n';
    return;
  }
  const Extent fine = work.pyramid.extent(0);
  const Extent coarse = work.pyramid.extent(a.levels);
  std::cout << a.input << " (" << fine.cols << " x " << fine.rows << ") -> " << a.output << " ("
            << coarse.cols << " x " << coarse.rows << "): " << work.scheme.text() << ", "
            << to_string(work.options.mode) << ", " << a.levels
            << (a.levels == 1 ? " level" : " levels") << '\n';
  if (!a.details.empty())
    std::cout << a.details << ": " << summary.count.kept << " of " << summary.count.all
              << " details kept, " << summary.bytes << " bytes; restored, the RMSE is "
              << summary.error.rmse << " and the largest error " << summary.error.largest << '\n';
}

#ifdef ARETE_HAVE_OPENMESH
void coarsen_as_mesh(const CoarsenArguments& a) {
  if (!a.raster_option.empty())
    throw Misuse(a.raster_option + " is for rasters; " + a.input + " is a mesh");
  coarsen_mesh({a.input, a.output, a.details, a.scheme, a.rim, a.boundary_given ? a.boundary : "",
                a.mode, a.levels, a.threshold, a.target_rmse, a.overwrite, a.json});
}
#endif

void coarsen(const CoarsenArguments& a) {
  check_thinning(a);
#ifdef ARETE_HAVE_OPENMESH
  if (openmesh::is_mesh_file(a.input)) return coarsen_as_mesh(a);
#endif
  check_raster_arguments(a);
  const auto start = std::chrono::steady_clock::now();
  const Scheme scheme = read_scheme(a.scheme);
  const GridReverseOptions options{a.levels, parse_reverse_mode(a.mode),
                                   parse_boundaries(a.boundary), a.threads};
  const double memory = a.max_memory.empty() ? default_memory() : parse_memory_size(a.max_memory);
  const gdal::Raster input(a.input);
  const Extent fine = input.extent();
  const auto type = a.type == "float32" ? gdal::SampleType::float32 : gdal::SampleType::float64;
  const Work work{a, scheme, options, type, GridPyramid(scheme.mask(), fine, options)};

  const double samples = static_cast<double>(fine.rows) * static_cast<double>(fine.cols);
  // The band, its parts twice (kept and being restored), a level under work; details of all bands.
  const double held = a.details.empty() ? 0 : 8 * static_cast<double>(input.bands().size() + 4);
  check_memory("taking " + a.input + " apart", samples * (24 + held), memory);

  OutputFile output(a.output, a.input, a.overwrite);
  std::optional<OutputFile> details_output;
  if (!a.details.empty()) details_output.emplace(a.details, a.input, a.overwrite);

  DetailsFile file{scheme.text(),
                   options.mode,
                   options.boundaries,
                   a.levels,
                   fine,
                   a.threshold.value_or(0) > 0 || a.target_rmse.value_or(0) > 0,
                   RasterNotes::of(input).text(),
                   {}};
  Summary summary;
  std::vector<Grid<double>> coarse;
  std::vector<ValidSamples> valid(input.bands().size());
  {
    ProgressBar progress("coarsening");
    for (std::size_t i = 0; i < input.bands().size(); ++i) {
      progress.show(static_cast<double>(i) / static_cast<double>(input.bands().size()));
      coarse.push_back(work.coarsen_band(gdal::read_band<double>(input, input.bands()[i]), valid[i],
                                         file, summary));
    }
  }
  gdal::GeoTiffSpec spec = spec_like(input, work.pyramid.extent(a.levels), type);
  if (input.georeference())
    spec.georeference = refined(*input.georeference(), work.pyramid.row_placement(a.levels),
                                work.pyramid.col_placement(a.levels));
  carry_control_points(input, LevelPlace::of(work.pyramid, 0),
                       LevelPlace::of(work.pyramid, a.levels), spec);
  // NaN can never be mistaken for a height.
  for (const ValidSamples& band : valid)
    if (!band.empty()) spec.nodata = std::numeric_limits<double>::quiet_NaN();
  write_bands(output.temporary(), spec, coarse, valid);
  if (details_output) summary.bytes = write_details(details_output->temporary(), file);
  stop_if_interrupted();
  if (details_output) details_output->commit();
  output.commit();
  report(a, work, summary, coarse.size(),
         std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}

}  // namespace

void add_coarsen(CLI::App& program, Job& job) {
  CLI::App* verb = program.add_subcommand(
      "coarsen", "Take a raster or mesh apart: a coarse one and the details that restore it");
  auto a = std::make_shared<CoarsenArguments>();
  verb->add_option("IN", a->input, "Any raster that GDAL reads, or a mesh: .obj, .ply, .off, .stl")
      ->required();
  verb->add_option("OUT", a->output, "The coarse raster, a .tif, or mesh")->required();
  verb->add_option("--scheme", a->scheme,
                   "Scheme whose refinement is undone, e.g. chaikin ('arete schemes' lists all); "
                   "of meshes catmull-clark, loop, loop-warren, doo-sabin, or any of the catalogue "
                   "where the mesh is one grid of quads")
      ->required();
  verb->add_option("--rim", a->rim,
                   "How the boundary of an open mesh was made: smooth, sharp-corners or thirds "
                   "(default: what fits best)");
  verb->add_option("--levels", a->levels, "How many steps are undone")->capture_default_str();
  verb->add_option("--details", a->details,
                   "Where to keep what 'arete restore' needs to give the input back");
  verb->add_option("--mode", a->mode,
                   "least-squares: the best coarse raster, any scheme; local: short filters "
                   "(interpolatory schemes, corner cutting, cubic B-spline), exact when dyadic")
      ->capture_default_str();
  verb->add_option("--boundary", a->boundary,
                   "extrapolate, clamp, reflect or periodic; or two of them, x then y")
      ->capture_default_str();
  verb->add_option("--threshold", a->threshold,
                   "Drop details up to this size, in units of the heights (lossy)");
  verb->add_option("--target-rmse", a->target_rmse,
                   "Drop as many details as this root mean square error allows (lossy)");
  verb->add_option("--threads", a->threads, "0: as many as the machine has; never changes a bit")
      ->check(CLI::Range(0, 4096))
      ->capture_default_str();
  verb->add_option("--max-memory", a->max_memory,
                   "Memory to hold at most, e.g. 800M (default: half of the machine's)");
  verb->add_option("--type", a->type,
                   "Samples of the coarse raster; float32 rounds them, so restoring is not exact")
      ->check(CLI::IsMember({"float32", "float64"}))
      ->capture_default_str();
  verb->add_flag("--overwrite", a->overwrite, "Replace OUT and the details if they exist");
  verb->add_flag("--json", a->json, "Print one JSON object about what was done");
  verb->callback([&job, a, verb] {
    a->boundary_given = verb->count("--boundary") > 0;
    for (const char* option : {"--threads", "--max-memory", "--type"})
      if (a->raster_option.empty() && verb->count(option) > 0) a->raster_option = option;
    job = [a] { coarsen(*a); };
  });
}

}  // namespace arete::cli
