// SPDX-License-Identifier: MIT
// arete validate: the grid engine beside other people's Catmull-Clark.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iostream>
#include <limits>
#include <memory>
#include <random>

#include "arete/refine/free_corners.h"
#include "arete/refine/refiner.h"
#include "cli/data_file.h"
#include "cli/error.h"
#include "cli/memory_size.h"
#include "cli/progress.h"
#include "cli/scheme_json.h"
#include "cli/verb.h"
#ifdef ARETE_HAVE_CGAL
#include "arete/cgal/catmull_clark.h"
#endif
#ifdef ARETE_HAVE_GDAL
#include "arete/gdal/band_source.h"
#endif
#ifdef ARETE_HAVE_OPENMESH
#include "arete/openmesh/catmull_clark.h"
#endif
#ifdef ARETE_HAVE_OPENSUBDIV
#include "arete/opensubdiv/catmull_clark.h"
#endif

namespace arete::cli {
namespace {

struct ValidateArguments {
  std::string data;
  int levels = 3;
  bool json = false;
};

struct Data {
  std::string name;
  Grid<double> heights;
};

// What is compared: how the rim's corners behave, and how far from the rim, or from the corners,
// the comparison begins (in input samples).
struct Oracle {
  std::string name;
  std::string region;
  std::function<Grid<double>(const Grid<double>&, int)> refine;
  bool free_corners = false;
  int rim = 0;
  int corners = 0;
  /// The largest difference that is rounding, relative to the largest height: 0 where weights are
  /// dyadic and sums therefore exact.
  double allowed = 0;
};

struct Row {
  std::string against;
  std::string region;
  std::string data;
  int levels = 0;
  double difference = 0;
  double allowed = 0;
  [[nodiscard]] bool holds() const { return difference <= allowed; }
};

std::vector<Oracle> oracles([[maybe_unused]] std::vector<std::string>& missing) {
  std::vector<Oracle> all;
#ifdef ARETE_HAVE_OPENSUBDIV
  using opensubdiv::CornerRule;
  const auto catmark = [](CornerRule corners) {
    return [corners](const Grid<double>& heights, int levels) {
      return opensubdiv::catmull_clark(heights, levels, corners);
    };
  };
  all.push_back({"OpenSubdiv EDGE_AND_CORNER", "whole grid", catmark(CornerRule::sharp)});
  const auto smooth = catmark(CornerRule::smooth);
  all.push_back({"OpenSubdiv EDGE_ONLY", "off the corners", smooth, false, 0, 2});
  all.push_back({"OpenSubdiv EDGE_ONLY", "corners freed", smooth, true});
#else
  missing.emplace_back("OpenSubdiv (libosd-dev)");
#endif
#ifdef ARETE_HAVE_CGAL
  const std::string name = "CGAL CatmullClark_subdivision";
  all.push_back({name, "off the corners", cgal::catmull_clark, false, 0, 2, 1e-14});
  all.push_back({name, "corners freed", cgal::catmull_clark, true, 0, 0, 1e-14});
#else
  missing.emplace_back("CGAL (libcgal-dev)");
#endif
#ifdef ARETE_HAVE_OPENMESH
  all.push_back(
      {"OpenMesh CatmullClarkT", "2 samples inside", openmesh::catmull_clark, false, 2, 0, 1e-14});
#else
  missing.emplace_back("OpenMesh (libopenmesh-dev)");
#endif
  return all;
}

Grid<double> flat_grid(Extent extent) {
  Grid<double> grid(extent);
  for (Index r = 0; r < extent.rows; ++r)
    for (Index c = 0; c < extent.cols; ++c)
      grid(r, c) = 3 + static_cast<double>(r) / 2 - static_cast<double>(c) / 4;
  return grid;
}

// Multiples of 1/1024 in 0..1.
Grid<double> random_grid(Extent extent) {
  std::mt19937 random(2026);
  Grid<double> grid(extent);
  for (double& height : grid.samples()) height = static_cast<double>(random() % 1025) / 1024;
  return grid;
}

#ifdef ARETE_HAVE_GDAL
Data terrain(const ValidateArguments& arguments) {
  const std::filesystem::path bundled = data_folder() / "jacksboro_srtm3.tif";
  if (arguments.data.empty() && !std::filesystem::exists(bundled))
    throw Failure(bundled.string() + " is missing; give a raster with --data");
  const gdal::Raster raster(arguments.data.empty() ? bundled.string() : arguments.data);
  const double samples = std::ldexp(static_cast<double>(raster.extent().rows), arguments.levels) *
                         std::ldexp(static_cast<double>(raster.extent().cols), arguments.levels);
  // CGAL's mesh, its copy as plain arrays, the grids.
  check_memory("validating with " + raster.path(), 400 * samples, default_memory());
  Grid<double> heights = gdal::read_band<double>(raster, raster.bands().front());
  for (const double height : heights.samples())
    if (!std::isfinite(height))
      throw Failure(raster.path() +
                    " has missing samples, which the other programs do not know; give a raster "
                    "without holes");
  return {std::filesystem::path(raster.path()).filename().string(), std::move(heights)};
}
#endif

// Over the samples at least `rim` from the rim, and not within `corners` of a corner along both
// axes.
double largest_difference(const Grid<double>& ours, const Grid<double>& theirs, Index rim,
                          Index corners) {
  if (ours.extent() != theirs.extent()) return std::numeric_limits<double>::infinity();
  double largest = 0;
  for (Index r = rim; r < ours.rows() - rim; ++r) {
    for (Index c = rim; c < ours.cols() - rim; ++c) {
      if (std::min(r, ours.rows() - 1 - r) < corners && std::min(c, ours.cols() - 1 - c) < corners)
        continue;
      const double difference = std::abs(ours(r, c) - theirs(r, c));
      // A NaN compares with nothing.
      if (!(difference <= largest))
        largest = std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference;
    }
  }
  return largest;
}

double largest_height(const Grid<double>& grid) {
  double largest = 0;
  for (const double height : grid.samples()) largest = std::max(largest, std::abs(height));
  return largest;
}

std::vector<Row> compare(const std::vector<Data>& data, const std::vector<Oracle>& all,
                         int levels) {
  const Scheme cubic = parse_scheme("b-spline:degree=3");
  ProgressBar progress("validating");
  double work = 0;
  for (const Data& item : data)
    for (int level = 1; level <= levels; ++level)
      work += std::ldexp(static_cast<double>(item.heights.samples().size()), 2 * level);
  double done = 0;
  std::vector<Row> rows;
  for (const Data& item : data) {
    for (int level = 1; level <= levels; ++level) {
      const double share =
          std::ldexp(static_cast<double>(item.heights.samples().size()), 2 * level);
      RefineOptions options;
      options.levels = level;
      const Grid<double> plain = refine(item.heights, cubic, options);
      const Grid<double> free_corners = refine_free_corners(item.heights, level);
      for (const Oracle& oracle : all) {
        const Grid<double>& ours = oracle.free_corners ? free_corners : plain;
        const double difference =
            largest_difference(ours, oracle.refine(item.heights, level), Index{oracle.rim} << level,
                               Index{oracle.corners} << level);
        rows.push_back({oracle.name, oracle.region, item.name, level, difference,
                        oracle.allowed * largest_height(item.heights)});
        done += share / static_cast<double>(all.size());
        progress.show(done / work);
      }
    }
  }
  return rows;
}

void print_json(const std::vector<Row>& rows, const std::vector<std::string>& missing) {
  Json object{{"rows", Json::array()}};
  for (const Row& row : rows)
    object["rows"].push_back({{"against", row.against},
                              {"data", row.data},
                              {"levels", row.levels},
                              {"max_difference", row.difference},
                              {"region", row.region},
                              {"allowed", row.allowed},
                              {"holds", row.holds()}});
  object["missing"] = missing;
  std::cout << object.dump(2) << '\n';
}

void print_table(const std::vector<Row>& rows, const std::vector<std::string>& missing) {
  std::printf("%-30s %-17s %-20s %6s  %14s  %s\n", "against", "where", "data", "levels",
              "max difference", "allowed");
  for (const Row& row : rows)
    std::printf("%-30s %-17s %-20s %6d  %14.3g  %.1e%s\n", row.against.c_str(), row.region.c_str(),
                row.data.c_str(), row.levels, row.difference, row.allowed,
                row.holds() ? "" : "  DIFFERS");
  std::puts(
      "\nours: b-spline:degree=3, boundary extrapolate. EDGE_ONLY and CGAL round the grid's four\n"
      "corners off: the same but within 2 samples of a corner, and the same everywhere when ours\n"
      "has (6 p + a + b) / 8 at the corners of each level (corners freed).\n"
      "OpenMesh: inside only; its rule at the rim, [1, 3, 4, 3, 1] / 6, is not Catmull-Clark's.");
  for (const std::string& name : missing)
    std::printf("not compared: %s; this arete was built without it\n", name.c_str());
  std::fflush(stdout);
}

void validate(const ValidateArguments& arguments) {
  std::vector<std::string> missing;
  const std::vector<Oracle> all = oracles(missing);
  if (all.empty())
    throw Failure(
        "this arete was built without OpenSubdiv, CGAL and OpenMesh: there is nothing to "
        "compare with");
  std::vector<Data> data{{"flat grid 17 x 33", flat_grid({17, 33})},
                         {"random grid 49 x 65", random_grid({49, 65})}};
#ifdef ARETE_HAVE_GDAL
  data.push_back(terrain(arguments));
#else
  missing.emplace_back("the bundled DEM (libgdal-dev)");
#endif
  const std::vector<Row> rows = compare(data, all, arguments.levels);
  if (arguments.json)
    print_json(rows, missing);
  else
    print_table(rows, missing);
  const auto differing =
      std::count_if(rows.begin(), rows.end(), [](const Row& r) { return !r.holds(); });
  if (differing > 0)
    throw Failure(std::to_string(differing) + " of " + std::to_string(rows.size()) +
                  " comparisons differ by more than rounding; please report it with this table");
}

}  // namespace

void add_validate(CLI::App& program, Job& job) {
  CLI::App* verb = program.add_subcommand(
      "validate",
      "Compare the cubic B-spline with Catmull-Clark by OpenSubdiv, CGAL and OpenMesh:\n"
      "largest differences on a flat grid, a random grid and a DEM");
  auto a = std::make_shared<ValidateArguments>();
  verb->add_option("--data", a->data,
                   "The DEM: any raster without holes (default: the bundled one, in "
                   "share/arete/data beside bin/)");
  verb->add_option("--levels", a->levels, "Compare levels 1 to N")
      ->check(CLI::Range(1, 6))
      ->capture_default_str();
  verb->add_flag("--json", a->json, "Print one JSON object");
  verb->callback([&job, a] { job = [a] { validate(*a); }; });
}

}  // namespace arete::cli
