// SPDX-License-Identifier: MIT
// arete map: smoothness over one or two parameters.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <thread>

#include "arete/analysis/smoothness_map.h"
#include "cli/error.h"
#include "cli/interruption.h"
#include "cli/map_outlines.h"
#include "cli/map_plane.h"
#include "cli/output_file.h"
#include "cli/progress.h"
#include "cli/verb.h"
#ifdef ARETE_HAVE_VTK
#include "cli/map_picture.h"
#endif

namespace arete::cli {
namespace {

struct MapArguments {
  std::string scheme;
  std::string output;
  std::string x;
  std::string y;
  std::string show = "order";
  int max_power = 4;
  std::string size;
  bool no_outlines = false;
  bool overwrite = false;
};

void write_csv(const std::filesystem::path& path, const MapRange& x, const MapRange& y,
               const std::vector<MapCell>& cells) {
  const auto column = [](const MapRange& range, const char* fallback) {
    return range.keys.size() == 1 ? range.name : fallback;
  };
  const bool plane = !y.keys.empty();
  std::ofstream stream(path);
  stream << column(x, "x") << (plane ? "," : "") << (plane ? column(y, "y") : "")
         << ",valid,certified,refuted_next,stable,hoelder_lower\n";
  stream.precision(12);
  for (std::size_t j = 0; j < y.values.size(); ++j)
    for (std::size_t i = 0; i < x.values.size(); ++i) {
      const MapCell& cell = cells[j * x.values.size() + i];
      stream << to_double(x.values[i]) << ',';
      if (plane) stream << to_double(y.values[j]) << ',';
      stream << cell.valid << ',' << cell.certified << ',' << cell.refuted_next << ','
             << cell.stable << ',' << cell.hoelder_lower << '\n';
    }
  stream.close();
  if (!stream) throw Failure(path.string() + " cannot be written; check free space");
}

std::vector<MapCell> compute(const MapPlane& plane, const MapRange& x, const MapRange& y,
                             const MapArguments& a) {
  SmoothnessOptions options = map_options(a.max_power);
  // A line has few points, and its graph is read off: there the bounds are as sharp as those of
  // `arete analyze`.
  if (a.show == "hoelder" && y.keys.empty()) options.jsr = {};
  options.jsr.stop = is_interrupted;
  ProgressBar bar("mapping");
  const double total = static_cast<double>(x.values.size() * y.values.size());
  std::atomic<std::size_t> finished{0};
  // The bar is for one thread; the others only count.
  const auto owner = std::this_thread::get_id();
  return smoothness_map(
      x.values, y.values,
      [&](const Rational& u, const Rational& v) {
        const auto scheme = plane.scheme(u, v);
        return scheme ? std::optional(scheme->mask()) : std::nullopt;
      },
      options,
      [&](std::size_t done) {
        finished = std::max(finished.load(), done);
        if (std::this_thread::get_id() == owner) {
          try {
            bar.show(static_cast<double>(finished) / total);
          } catch (const Interrupted&) {
            return false;
          }
        }
        return true;
      });
}

const char* extent_text(PrintedRegion::Extent extent) {
  switch (extent) {
    case PrintedRegion::Extent::nowhere:
      return "nowhere";
    case PrintedRegion::Extent::inside:
      return "inside its outline";
    case PrintedRegion::Extent::everywhere:
      return "everywhere";
    case PrintedRegion::Extent::line:
      return "on its line only: its equality is no identity here";
    case PrintedRegion::Extent::points:
      return "at single points only: two of its equalities are no identities here";
  }
  return "";
}

void report(const MapArguments& a, const std::vector<MapCell>& cells,
            const std::vector<PrintedRegion>& regions) {
  std::map<int, std::size_t> counts;
  for (const MapCell& cell : cells) ++counts[cell.valid ? cell.certified : -2];
  std::cout << a.scheme << " -> " << a.output << ": " << cells.size() << " points";
  for (const auto& [order, count] : counts)
    std::cout << ", " << count << " "
              << (order == -2   ? "without scheme"
                  : order == -1 ? "not certified"
                                : "C^" + std::to_string(order));
  std::cout << '\n';
  for (const PrintedRegion& region : regions)
    std::cout << "    " << region.name << " holds " << extent_text(region.extent) << '\n';
}

void draw_map(const MapArguments& a) {
  const std::string form = std::filesystem::path(a.output).extension().string();
  if (form != ".csv" && form != ".png")
    throw Misuse(a.output + ": the format '" + form + "' is not one of .png, .csv");
#ifndef ARETE_HAVE_VTK
  if (form == ".png") throw Failure(a.output + ": this arete was built without VTK; write a .csv");
#endif
  const MapRange x = parse_range(a.x, "--x");
  const MapRange y = a.y.empty() ? no_range() : parse_range(a.y, "--y");
  const MapPlane plane(a.scheme, x, y);
  OutputFile output(a.output, "", a.overwrite);
#ifdef ARETE_HAVE_VTK
  const auto size = picture_size(a.size, y);
#endif
  const std::vector<MapCell> cells = compute(plane, x, y, a);
  stop_if_interrupted();
  std::vector<PrintedRegion> regions;
  if (form == ".png" && !a.no_outlines) regions = printed_regions(plane, x, y);
#ifdef ARETE_HAVE_VTK
  if (form == ".png")
    draw_map_picture({x, y, cells, regions, a.show == "hoelder"}, size, output.temporary());
#endif
  if (form == ".csv") write_csv(output.temporary(), x, y, cells);
  stop_if_interrupted();
  output.commit();
  report(a, cells, regions);
}

}  // namespace

void add_map(CLI::App& program, Job& job) {
  CLI::App* verb = program.add_subcommand(
      "map", "Map the certified smoothness over two parameters of a family (.png or .csv)");
  auto a = std::make_shared<MapArguments>();
  verb->add_option("SCHEME", a->scheme, "The family, with values for its other parameters")
      ->required();
  verb->add_option("OUT", a->output, "The format follows the extension: .png, .csv")->required();
  verb->add_option("--x", a->x, "KEY=LOW:HIGH:COUNT, or KEY,KEY=... for keys that move together")
      ->required();
  verb->add_option("--y", a->y, "The same for the other axis; without it a map of one parameter");
  verb->add_option("--show", a->show,
                   "What is shown: order (certified C^k) or hoelder (the proved lower bound of the "
                   "exponent; over one parameter as a graph)")
      ->check(CLI::IsMember({"order", "hoelder"}))
      ->capture_default_str();
  verb->add_option("--max-power", a->max_power, "Highest power of the norms that are tried")
      ->check(CLI::Range(1, 16))
      ->capture_default_str();
  verb->add_option("--size", a->size, "WIDTHxHEIGHT of the picture (default 1000x800)");
  verb->add_flag("--no-outlines", a->no_outlines,
                 "Leave out the regions that the family's papers print");
  verb->add_flag("--overwrite", a->overwrite, "Replace OUT if it exists");
  verb->callback([&job, a] { job = [a] { draw_map(*a); }; });
}

}  // namespace arete::cli
