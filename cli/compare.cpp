// SPDX-License-Identifier: MIT
// arete compare: how far one raster is from another, and how rough both are.
#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>

#include "arete/metrics/difference.h"
#include "arete/metrics/spectrum.h"
#include "cli/common_lattice.h"
#include "cli/error.h"
#include "cli/interruption.h"
#include "cli/json_number.h"
#include "cli/memory_size.h"
#include "cli/scheme_json.h"
#include "cli/verb.h"

namespace arete::cli {
namespace {

struct CompareArguments {
  std::string first;
  std::string second;
  int band = 1;
  std::string max_memory;
  bool json = false;
};

struct Comparison {
  Extent extent;
  HeightDifference heights;
  SlopeDifference slopes;
  std::optional<SpectralSlope> first_spectrum, second_spectrum;
  WorldPoint largest_at;
};

Comparison measure(const CommonLattice& common, bool degrees) {
  Comparison result;
  result.extent = common.first.extent();
  result.heights = compare_heights(common.first.view(), common.second.view());
  stop_if_interrupted();
  result.slopes = compare_slopes(common.first.view(), common.second.view(),
                                 ground_spacing(common.place, result.extent, degrees));
  stop_if_interrupted();
  result.first_spectrum = spectral_slope(common.first.view());
  result.second_spectrum = spectral_slope(common.second.view());
  result.largest_at = common.place.position(static_cast<double>(result.heights.largest_row),
                                            static_cast<double>(result.heights.largest_col));
  return result;
}

void print_json(const CompareArguments& a, const Comparison& c) {
  const HeightDifference& h = c.heights;
  const Json object{
      {"first", a.first},
      {"second", a.second},
      {"rows", c.extent.rows},
      {"cols", c.extent.cols},
      {"compared", h.compared},
      {"only_first", h.only_first},
      {"only_second", h.only_second},
      {"rmse", number_or_null(h.rmse)},
      {"bias", number_or_null(h.mean)},
      {"mean_absolute", number_or_null(h.mean_absolute)},
      {"max", number_or_null(h.largest)},
      {"max_at",
       {{"row", h.largest_row},
        {"col", h.largest_col},
        {"x", c.largest_at.x},
        {"y", c.largest_at.y}}},
      {"slope_rmse", number_or_null(c.slopes.rmse)},
      {"spectral_slope",
       {{"first", slope_or_null(c.first_spectrum)}, {"second", slope_or_null(c.second_spectrum)}}}};
  std::cout << object.dump(2) << '\n';
}

void print_text(const CompareArguments& a, const Comparison& c) {
  const HeightDifference& h = c.heights;
  std::ostringstream text;
  text << std::setprecision(6);
  text << a.second << " against " << a.first << ", " << h.compared << " samples of "
       << c.extent.cols << " x " << c.extent.rows << '\n'
       << "  RMSE            " << h.rmse << '\n'
       << "  bias            " << h.mean << '\n'
       << "  mean |error|    " << h.mean_absolute << '\n'
       << "  largest |error| " << h.largest << " at row " << h.largest_row << ", column "
       << h.largest_col << std::setprecision(12) << " (" << c.largest_at.x << ", " << c.largest_at.y
       << ")\n"
       << std::setprecision(6) << "  slope RMSE      " << c.slopes.rmse << " degrees\n";
  const auto spectrum = [&](const std::optional<SpectralSlope>& s) {
    if (s)
      text << std::fixed << std::setprecision(2) << s->slope << std::defaultfloat;
    else
      text << "none (fewer than " << shortest_profile << " samples in a row)";
  };
  text << "  spectral slope  ";
  spectrum(c.first_spectrum);
  text << " (first), ";
  spectrum(c.second_spectrum);
  text << " (second)\n";
  if (h.only_first + h.only_second > 0)
    text << "note: " << h.only_first << " samples exist only in the first and " << h.only_second
         << " only in the second\n";
  std::cout << text.str();
}

void compare(const CompareArguments& a) {
  const double memory = a.max_memory.empty() ? default_memory() : parse_memory_size(a.max_memory);
  const gdal::Raster first(a.first);
  const gdal::Raster second(a.second);
  const Comparison result = measure(read_common(first, second, a.band, memory), first.geographic());
  if (result.heights.compared == 0)
    throw Failure(a.first + " and " + a.second +
                  " have no valid sample in common; check their nodata values with gdalinfo");
  if (a.json)
    print_json(a, result);
  else
    print_text(a, result);
}

}  // namespace

void add_compare(CLI::App& program, Job& job) {
  CLI::App* verb = program.add_subcommand(
      "compare", "How far raster B is from raster A: RMSE, bias, largest error, slopes, roughness");
  auto a = std::make_shared<CompareArguments>();
  verb->add_option("A", a->first, "The truth: any raster that GDAL reads")->required();
  verb->add_option("B", a->second,
                   "A raster on the same lattice, or one that holds or refines A's samples")
      ->required();
  verb->add_option("--band", a->band, "Which band holds the heights")->capture_default_str();
  verb->add_option("--max-memory", a->max_memory,
                   "Memory to hold at most, e.g. 800M (default: half of the machine's)");
  verb->add_flag("--json", a->json, "Print one JSON object");
  verb->callback([&job, a] { job = [a] { compare(*a); }; });
}

}  // namespace arete::cli
