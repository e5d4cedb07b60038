// SPDX-License-Identifier: MIT
// arete grid: scattered points in, a control grid out.
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <limits>
#include <memory>
#include <sstream>

#include "arete/cgal/scattered_grid.h"
#include "arete/gdal/point_layer.h"
#include "arete/gdal/reference_system.h"
#include "cli/disk_space.h"
#include "cli/error.h"
#include "cli/interruption.h"
#include "cli/json_number.h"
#include "cli/memory_size.h"
#include "cli/number_list.h"
#include "cli/output_file.h"
#include "cli/progress.h"
#include "cli/raster_notes.h"
#include "cli/survey_points.h"
#include "cli/verb.h"

namespace arete::cli {
namespace {

struct GridArguments {
  std::string input;
  std::string output;
  std::string spacing;
  std::string size;
  std::string box;
  std::string method = "natural-neighbour";
  std::string outside = "nodata";
  int neighbours = 12;
  double power = 2;
  std::optional<double> drop_outliers;
  std::string columns;
  std::string separator;
  std::string layer;
  std::string height_field;
  std::string crs;
  std::string type = "float32";
  std::vector<std::string> creation_options;
  int threads = 0;
  std::string max_memory;
  bool overwrite = false;
  bool json = false;
};

bool is_text(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const char* known : {".csv", ".xyz", ".txt", ".dat", ".tsv", ".pts"})
    if (extension == known) return true;
  return false;
}

SurveyPoints read_input(const GridArguments& a) {
  SurveyPoints points;
  if (is_text(a.input)) {
    if (!a.layer.empty() || !a.height_field.empty())
      throw Misuse("--layer and --z-field belong to vector layers; a text file has --columns");
    SurveyFormat format;
    if (!a.columns.empty()) format.columns = parse_columns(a.columns);
    format.separator = a.separator == "\\t" ? "\t" : a.separator;
    points = read_survey(a.input, format);
  } else {
    if (!a.columns.empty() || !a.separator.empty())
      throw Misuse("--columns and --separator belong to text files; a vector layer has --z-field");
    gdal::PointLayer layer = gdal::read_points(a.input, a.layer, a.height_field);
    points = {std::move(layer.x), std::move(layer.y), std::move(layer.z), std::move(layer.crs)};
  }
  if (a.crs.empty()) return points;
  const std::string crs = gdal::crs_from_text(a.crs);
  if (!points.crs.empty() && !gdal::same_crs(points.crs, crs))
    throw Failure(a.input +
                  " names another reference system than --crs; leave --crs out, or reproject the "
                  "points first with ogr2ogr -t_srs");
  points.crs = crs;
  return points;
}

// Degrees can only be degrees.
void check_degrees(const SurveyPoints& points, const std::string& path) {
  if (points.crs.empty() || !gdal::is_geographic(points.crs)) return;
  for (std::size_t i = 0; i < points.x.size(); ++i)
    if (std::abs(points.x[i]) > 360 || std::abs(points.y[i]) > 90)
      throw Failure(path + ", point " + std::to_string(i + 1) + " at " +
                    std::to_string(points.x[i]) + ", " + std::to_string(points.y[i]) +
                    " is no longitude and latitude, but its reference system is in degrees; name "
                    "the right one with --crs");
}

cgal::GridRequest request_from(const GridArguments& a) {
  cgal::GridRequest request;
  if (a.spacing.empty() == a.size.empty()) throw Misuse("give either --spacing D or --size CxR");
  if (!a.spacing.empty()) {
    const auto d = parse_numbers(a.spacing, ',', 1, 2, "--spacing takes D or DX,DY, e.g. 25");
    request.spacing = WorldPoint{d.front(), d.back()};
  }
  if (!a.size.empty()) {
    const auto n = parse_numbers(a.size, 'x', 2, 2, "--size takes columns x rows, e.g. 200x160");
    for (const double count : n)
      if (count != std::floor(count) || count < 2 || count > 1e9)
        throw Misuse("--size takes whole numbers from 2 on, e.g. 200x160 (got '" + a.size + "')");
    request.size = Extent{static_cast<Index>(n[1]), static_cast<Index>(n[0])};
  }
  if (!a.box.empty()) {
    const auto b =
        parse_numbers(a.box, ',', 4, 4, "--box takes XMIN,YMIN,XMAX,YMAX, e.g. 0,0,100,80");
    request.box = cgal::PlaneBox{b[0], b[1], b[2], b[3]};
  }
  request.method = cgal::parse_grid_method(a.method);
  request.outside = cgal::parse_outside(a.outside);
  request.neighbours = a.neighbours;
  request.power = a.power;
  request.drop_outliers = a.drop_outliers;
  request.threads = a.threads;
  return request;
}

void write(const GridArguments& a, const std::filesystem::path& path,
           const cgal::GriddedPoints& result, const std::string& crs) {
  gdal::GeoTiffSpec spec;
  spec.extent = result.heights.extent();
  spec.type = a.type == "float64" ? gdal::SampleType::float64 : gdal::SampleType::float32;
  spec.georeference = result.georeference;
  spec.crs = crs;
  spec.bands.resize(1);
  spec.nodata = std::numeric_limits<double>::quiet_NaN();
  spec.threads = a.threads;
  spec.creation_options = a.creation_options;
  write_bands(path, spec, {result.heights}, {ValidSamples{}});
}

void report_json(const GridArguments& a, const cgal::GriddedPoints& result, double seconds) {
  const auto& g = result.georeference.affine;
  const Json object{{"input", a.input},
                    {"output", a.output},
                    {"rows", result.heights.rows()},
                    {"cols", result.heights.cols()},
                    {"spacing", {{"x", g[1]}, {"y", -g[5]}}},
                    {"method", a.method},
                    {"outside", a.outside},
                    {"points",
                     {{"given", result.given},
                      {"used", result.used},
                      {"merged", result.merged},
                      {"not_finite", result.not_finite},
                      {"outliers", result.outliers}}},
                    {"missing", result.missing},
                    {"distance_to_points",
                     {{"covered", result.covered},
                      {"rmse", number_or_null(result.rmse)},
                      {"max", number_or_null(result.largest_error)}}},
                    {"seconds", seconds}};
  std::cout << object.dump(2) << '\n';
}

void report_text(const GridArguments& a, const cgal::GriddedPoints& result, bool degrees,
                 double seconds) {
  const auto& g = result.georeference.affine;
  std::ostringstream text;
  text << a.input << " (" << result.used << " points) -> " << a.output << " ("
       << result.heights.cols() << " x " << result.heights.rows() << ", spacing " << g[1];
  if (g[1] != -g[5]) text << " x " << -g[5];
  text << "): " << a.method << ", " << std::fixed << std::setprecision(2) << seconds << " s\n"
       << std::defaultfloat << std::setprecision(4);
  if (result.covered > 0)
    text << "the grid passes by its points at " << result.rmse << " (RMSE) and "
         << result.largest_error << " (at most)\n";
  const auto note = [&](Index count, const char* what) {
    if (count > 0) text << "note: " << count << ' ' << what << '\n';
  };
  note(result.merged, "points lie where others do; their mean heights were taken");
  note(result.not_finite, "points without three finite numbers were passed over");
  note(result.outliers, "points far off their neighbours' plane were dropped");
  note(result.missing, "samples outside the points' hull are nodata (--outside chooses)");
  if (degrees)
    text << "note: the coordinates are degrees, in which x and y are not of equal length; project "
            "the points first where that matters\n";
  std::cout << text.str();
}

void grid(const GridArguments& a) {
  const std::string form = std::filesystem::path(a.output).extension().string();
  if (form != ".tif" && form != ".tiff")
    throw Misuse(a.output + ": the control grid is a GeoTIFF; name it .tif");
  cgal::GridRequest request = request_from(a);
  const double memory = a.max_memory.empty() ? default_memory() : parse_memory_size(a.max_memory);
  const auto start = std::chrono::steady_clock::now();
  const SurveyPoints points = read_input(a);
  check_degrees(points, a.input);
  const cgal::ScatteredPoints places{points.x, points.y, points.z};
  const Extent extent = cgal::place_grid(places, request).extent;
  const double samples = static_cast<double>(extent.rows) * static_cast<double>(extent.cols);
  constexpr double bytes_per_point = 350;
  check_memory("a grid of " + std::to_string(extent.cols) + " x " + std::to_string(extent.rows) +
                   " samples from " + std::to_string(points.x.size()) + " points",
               24 * samples + bytes_per_point * static_cast<double>(points.x.size()), memory);
  check_disk(a.output, a.creation_options, samples * (a.type == "float64" ? 8 : 4));
  OutputFile output(a.output, a.input, a.overwrite);
  cgal::GriddedPoints result;
  {
    ProgressBar progress("gridding");
    request.progress = [&](double share) { progress.show(share); };
    result = cgal::grid_points(places, request);
  }
  stop_if_interrupted();
  write(a, output.temporary(), result, points.crs);
  stop_if_interrupted();
  output.commit();
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (a.json)
    report_json(a, result, seconds);
  else
    report_text(a, result, !points.crs.empty() && gdal::is_geographic(points.crs), seconds);
}

}  // namespace

void add_grid(CLI::App& program, Job& job) {
  CLI::App* verb = program.add_subcommand(
      "grid", "Make a control grid (.tif) from scattered points: survey heights, soundings");
  auto a = std::make_shared<GridArguments>();
  verb->add_option("POINTS", a->input,
                   "Text (.csv, .xyz, .txt, .dat, .tsv, .pts) or a point layer that GDAL reads "
                   "(.gpkg, .shp, .geojson, ...)")
      ->required();
  verb->add_option("OUT", a->output, "The control grid, a .tif")->required();
  verb->add_option("--spacing", a->spacing, "Distance of samples, D or DX,DY");
  verb->add_option("--size", a->size, "Columns x rows, the outermost on the points' bounding box");
  verb->add_option("--box", a->box,
                   "XMIN,YMIN,XMAX,YMAX: where samples lie (default: the points' bounding box)");
  verb->add_option("--method", a->method,
                   "natural-neighbour (smooth), linear (triangles) or idw (inverse distance)")
      ->capture_default_str();
  verb->add_option("--outside", a->outside,
                   "Outside the points' hull: nodata, nearest or extrapolate")
      ->capture_default_str();
  verb->add_option("--neighbours", a->neighbours, "idw: how many of the nearest points count")
      ->capture_default_str();
  verb->add_option("--power", a->power, "idw: weights fall with this power of the distance")
      ->capture_default_str();
  verb->add_option("--drop-outliers", a->drop_outliers,
                   "Drop points further than this many robust standard deviations from the plane "
                   "through their neighbours, e.g. 20");
  verb->add_option("--columns", a->columns,
                   "Text: names or numbers of the columns of x, y and height, e.g. 2,3,5");
  verb->add_option("--separator", a->separator,
                   "Text: the sign between cells (default: , ; tab | or blanks)");
  verb->add_option("--layer", a->layer, "Vector file: which layer");
  verb->add_option("--z-field", a->height_field,
                   "Vector file: the field that holds heights (default: the points' z)");
  verb->add_option("--crs", a->crs, "Reference system of the points, e.g. EPSG:32633");
  verb->add_option("--type", a->type, "Samples of the result")
      ->check(CLI::IsMember({"float32", "float64"}))
      ->capture_default_str();
  verb->add_option("--creation-option", a->creation_options,
                   "KEY=VALUE of GDAL's GTiff driver, may be repeated")
      ->expected(1)
      ->take_all();
  verb->add_option("--threads", a->threads, "0: as many as the machine has; never changes a bit")
      ->check(CLI::Range(0, 4096))
      ->capture_default_str();
  verb->add_option("--max-memory", a->max_memory,
                   "Memory to hold at most, e.g. 800M (default: half of the machine's)");
  verb->add_flag("--overwrite", a->overwrite, "Replace OUT if it exists");
  verb->add_flag("--json", a->json, "Print one JSON object about what was done");
  verb->callback([&job, a] { job = [a] { grid(*a); }; });
}

}  // namespace arete::cli
