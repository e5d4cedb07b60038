// SPDX-License-Identifier: MIT
// arete restore: the raster or mesh that 'arete coarsen' took apart, or any level between.
#include <cmath>
#include <iostream>
#include <memory>
#include <optional>

#include "arete/gdal/band_source.h"
#include "arete/scheme/catalogue.h"
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
#include "cli/coarsen_mesh.h"
#endif

namespace arete::cli {
namespace {

struct RestoreArguments {
  std::string coarse;
  std::string output;
  std::string details;
  std::optional<int> levels;
  std::string type;
  int threads = 1;
  std::string max_memory;
  bool edited = false;
  bool overwrite = false;
  bool json = false;
  std::string raster_option;  // the first one given that says nothing to a mesh
};

void check_pair(const RestoreArguments& a, const gdal::Raster& raster, const DetailsFile& file,
                const GridPyramid& pyramid) {
  const Extent wanted = pyramid.extent(file.levels);
  if (!(raster.extent() == wanted))
    throw Failure(a.coarse + " has " + std::to_string(raster.extent().cols) + " x " +
                  std::to_string(raster.extent().rows) + " samples where " + a.details +
                  " belongs to " + std::to_string(wanted.cols) + " x " +
                  std::to_string(wanted.rows) + "; give the coarse raster it was written with");
  if (raster.bands().size() != file.bands.size())
    throw Failure(a.coarse + " has " + std::to_string(raster.bands().size()) + " bands where " +
                  a.details + " has " + std::to_string(file.bands.size()) +
                  "; give the coarse raster it was written with");
}

// The coarse samples of a band, with those that the raster calls missing put back.
Grid<double> coarse_samples(const RestoreArguments& a, const gdal::Raster& raster,
                            const gdal::BandInfo& info, const BandDetails& band,
                            const ValidSamples& valid) {
  Grid<double> samples = gdal::read_band<double>(raster, info);
  auto hidden = band.hidden.begin();
  for (std::size_t i = 0; i < samples.samples().size(); ++i) {
    double& value = samples.samples()[i];
    if (!valid.empty() && valid[i] == 0)
      value = *hidden++;
    else if (!std::isfinite(value))
      throw Failure(a.coarse + ", row " + std::to_string(static_cast<Index>(i) / samples.cols()) +
                    ", column " + std::to_string(static_cast<Index>(i) % samples.cols()) +
                    " is missing where " + a.details + " expects a height; fill it");
  }
  if (!a.edited && checksum(samples.samples()) != band.coarse_checksum)
    throw Failure(a.coarse + " is not the raster that " + a.details +
                  " was written with (checksum of band " + std::to_string(info.number) +
                  "); give that one, or --edited if it was changed on purpose");
  return samples;
}

void restore(const RestoreArguments& a) {
  if (holds_mesh_details(a.details)) {
#ifdef ARETE_HAVE_OPENMESH
    if (!a.raster_option.empty())
      throw Misuse(a.raster_option + " is for rasters; " + a.details + " is of a mesh");
    return restore_mesh({a.coarse, a.output, a.details, a.levels, a.edited, a.overwrite, a.json});
#else
    throw Failure(a.details + " is of a mesh, and this arete was built without OpenMesh");
#endif
  }
  const std::string form = std::filesystem::path(a.output).extension().string();
  if (form != ".tif" && form != ".tiff")
    throw Misuse(a.output + ": the restored raster is a GeoTIFF; name it .tif");
  const double memory = a.max_memory.empty() ? default_memory() : parse_memory_size(a.max_memory);
  DetailsFile file = read_details(a.details);
  const RasterNotes notes = RasterNotes::parse(file.notes);
  const Scheme scheme = parse_scheme(file.scheme);
  const GridReverseOptions options = file.options(a.threads);
  const GridPyramid pyramid(scheme.mask(), file.fine, options);
  const int steps = a.levels.value_or(file.levels);
  if (steps < 0 || steps > file.levels)
    throw Misuse("--levels " + std::to_string(steps) + ": " + a.details + " holds " +
                 std::to_string(file.levels) + "; give 0 to " + std::to_string(file.levels));
  const gdal::Raster raster(a.coarse);
  check_pair(a, raster, file, pyramid);
  const double samples = static_cast<double>(file.fine.rows) * static_cast<double>(file.fine.cols);
  check_memory("restoring " + a.output, 8 * samples * static_cast<double>(file.bands.size() + 3),
               memory);
  OutputFile output(a.output, a.coarse, a.overwrite);

  const int left = file.levels - steps;
  const bool whole = left == 0;
  std::vector<Grid<double>> bands;
  std::vector<ValidSamples> valid;
  {
    ProgressBar progress("restoring");
    for (std::size_t i = 0; i < file.bands.size(); ++i) {
      progress.show(static_cast<double>(i) / static_cast<double>(file.bands.size()));
      BandDetails& band = file.bands[i];
      GridDecomposition<double> parts{coarse_samples(a, raster, raster.bands()[i], band,
                                                     coarsened(band.valid, pyramid, file.levels)),
                                      std::move(band.details)};
      bands.push_back(reconstruct_grid(parts, file.fine, scheme, options, steps));
      valid.push_back(coarsened(std::move(band.valid), pyramid, left));
      // Whole numbers come back as whole numbers; only rounding errors are taken off.
      if (whole && notes.integers && !file.lossy && !a.edited)
        for (double& value : bands.back().samples()) value = std::nearbyint(value);
    }
  }
  const bool float64 = a.type.empty() ? notes.needs_float64 : a.type == "float64";
  gdal::GeoTiffSpec spec =
      spec_like(raster, pyramid.extent(left),
                float64 ? gdal::SampleType::float64 : gdal::SampleType::float32);
  if (notes.georeference)
    spec.georeference = whole ? *notes.georeference
                              : refined(*notes.georeference, pyramid.row_placement(left),
                                        pyramid.col_placement(left));
  carry_control_points(raster, LevelPlace::of(pyramid, file.levels), LevelPlace::of(pyramid, left),
                       spec);
  spec.nodata = notes.nodata;
  for (const ValidSamples& band : valid)
    if (!band.empty() && !spec.nodata) spec.nodata = std::numeric_limits<double>::quiet_NaN();
  write_bands(output.temporary(), spec, bands, valid);
  stop_if_interrupted();
  output.commit();
  const Extent extent = pyramid.extent(left);
  if (a.json)
    std::cout << Json{{"input", a.coarse},       {"details", a.details},
                      {"output", a.output},      {"rows", extent.rows},
                      {"cols", extent.cols},     {"bands", bands.size()},
                      {"levels", steps},         {"of_levels", file.levels},
                      {"scheme", scheme.text()}, {"mode", std::string(to_string(file.mode))},
                      {"lossy", file.lossy},     {"type", float64 ? "float64" : "float32"}}
                     .dump(2)
              << '\n';
  else
    std::cout << a.coarse << " + " << a.details << " -> " << a.output << " (" << extent.cols
              << " x " << extent.rows << "): " << steps << " of " << file.levels
              << " levels restored" << (file.lossy ? " from thinned details" : "") << '\n';
}

}  // namespace

void add_restore(CLI::App& program, Job& job) {
  CLI::App* verb = program.add_subcommand(
      "restore", "Give back the raster or mesh that 'arete coarsen' took apart");
  auto a = std::make_shared<RestoreArguments>();
  verb->add_option("COARSE", a->coarse, "The coarse raster or mesh")->required();
  verb->add_option("OUT", a->output, "The restored raster, a .tif, or mesh")->required();
  verb->add_option("--details", a->details, "The details written with COARSE")->required();
  verb->add_option("--levels", a->levels, "How many levels to restore (default: all)");
  verb->add_option("--type", a->type,
                   "Samples of the result (default: float32 when it holds the input exactly)")
      ->check(CLI::IsMember({"float32", "float64"}));
  verb->add_option("--threads", a->threads, "0: as many as the machine has; never changes a bit")
      ->check(CLI::Range(0, 4096))
      ->capture_default_str();
  verb->add_option("--max-memory", a->max_memory,
                   "Memory to hold at most, e.g. 800M (default: half of the machine's)");
  verb->add_flag("--edited", a->edited,
                 "COARSE was changed on purpose: add the details to it as it is");
  verb->add_flag("--overwrite", a->overwrite, "Replace OUT if it exists");
  verb->add_flag("--json", a->json, "Print one JSON object about what was done");
  verb->callback([&job, a, verb] {
    for (const char* option : {"--type", "--threads", "--max-memory"})
      if (a->raster_option.empty() && verb->count(option) > 0) a->raster_option = option;
    job = [a] { restore(*a); };
  });
}

}  // namespace arete::cli
