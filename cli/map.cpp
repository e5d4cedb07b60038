// SPDX-License-Identifier: MIT
// arete map: smoothness over a plane of two parameters.
#include <algorithm>
#include <atomic>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <thread>

#include "arete/analysis/smoothness_map.h"
#include "cli/error.h"
#include "cli/interruption.h"
#include "cli/output_file.h"
#include "cli/progress.h"
#include "cli/scheme_json.h"
#include "cli/verb.h"
#ifdef ARETE_HAVE_VTK
#include "arete/vtk/plot_map.h"
#endif

namespace arete::cli {
namespace {

struct MapArguments {
  std::string scheme;
  std::string output;
  std::string x;
  std::string y;
  int max_power = 4;
  std::string size = "1000x800";
  bool overwrite = false;
};

// `omega=0:1/2:101` or, for parameters that move together, `lambda,mu=0:1/4:51`.
struct MapRange {
  std::string name;
  std::vector<std::string> keys;
  std::vector<Rational> values;
};

MapRange parse_range(const std::string& text, const char* option) {
  const std::string form = std::string(option) + " '" + text +
                           "' is not of the form KEY=LOW:HIGH:COUNT, e.g. omega=0:1/2:101";
  const auto equals = text.find('=');
  const auto first = text.find(':');
  const auto second = first == std::string::npos ? first : text.find(':', first + 1);
  if (equals == std::string::npos || equals == 0 || second == std::string::npos || first < equals)
    throw Misuse(form);
  MapRange range{text.substr(0, equals), {}, {}};
  std::string keys = range.name + ",";
  for (auto comma = keys.find(','); comma != std::string::npos; comma = keys.find(',')) {
    range.keys.push_back(keys.substr(0, comma));
    keys.erase(0, comma + 1);
  }
  Rational low, high;
  Rational count;
  try {
    low = parse_rational(text.substr(equals + 1, first - equals - 1));
    high = parse_rational(text.substr(first + 1, second - first - 1));
    count = parse_rational(text.substr(second + 1));
  } catch (const std::invalid_argument&) {
    throw Misuse(form);
  }
  if (!is_integer(count) || count < 1 || count > 2000)
    throw Misuse(std::string(option) + ": the count must be an integer from 1 to 2000");
  const int n = static_cast<int>(boost::multiprecision::numerator(count));
  for (int i = 0; i < n; ++i)
    range.values.push_back(n == 1 ? low : Rational(low + (high - low) * i / (n - 1)));
  return range;
}

// The base scheme's parameters with those of the map put in their places.
class Plane {
 public:
  Plane(const std::string& text, const MapRange& x, const MapRange& y) : x_(x.keys), y_(y.keys) {
    const auto colon = text.find(':');
    family_ = text.substr(0, colon);
    std::string rest = colon == std::string::npos ? "" : text.substr(colon + 1);
    // Keys of the map get a value here, so that a parameter without default may be left to it.
    std::string base = family_;
    for (const MapRange* range : {&x, &y})
      for (const std::string& key : range->keys)
        rest += (rest.empty() ? "" : ",") + key + "=" + to_string(range->values.front());
    if (!rest.empty()) base += ":" + rest;
    values_ = parse_scheme(base).parameters();
  }

  [[nodiscard]] std::optional<Mask> mask(const Rational& x, const Rational& y) const {
    ParameterValues values = values_;
    for (ParameterValue& value : values) {
      if (std::find(x_.begin(), x_.end(), value.name) != x_.end()) value.numbers = {x};
      if (std::find(y_.begin(), y_.end(), value.name) != y_.end()) value.numbers = {y};
    }
    try {
      return make_scheme(family_, values).mask();
    } catch (const InvalidScheme&) {
      return std::nullopt;
    }
  }

 private:
  std::string family_;
  ParameterValues values_;
  std::vector<std::string> x_;
  std::vector<std::string> y_;
};

void write_csv(const std::filesystem::path& path, const MapRange& x, const MapRange& y,
               const std::vector<MapCell>& cells) {
  std::ofstream stream(path);
  stream << (x.keys.size() > 1 ? "x" : x.name) << ',' << (y.keys.size() > 1 ? "y" : y.name)
         << ",valid,certified,refuted_next,stable,hoelder_lower\n";
  stream.precision(12);
  for (std::size_t j = 0; j < y.values.size(); ++j)
    for (std::size_t i = 0; i < x.values.size(); ++i) {
      const MapCell& cell = cells[j * x.values.size() + i];
      stream << to_double(x.values[i]) << ',' << to_double(y.values[j]) << ',' << cell.valid << ','
             << cell.certified << ',' << cell.refuted_next << ',' << cell.stable << ','
             << cell.hoelder_lower << '\n';
    }
  stream.close();
  if (!stream) throw Failure(path.string() + " cannot be written; check free space");
}

#ifdef ARETE_HAVE_VTK
constexpr int highest_class = 6;

std::vector<vtk::MapClass> map_classes() {
  std::vector<vtk::MapClass> classes{{"no scheme", {255, 255, 255}},
                                     {"does not converge", {60, 60, 66}},
                                     {"undecided", {190, 190, 190}}};
  // From warm (rough) to cold (smooth); readable without colour by its falling lightness.
  const std::vector<vtk::Rgb> ramp{{250, 214, 140}, {240, 160, 80}, {215, 95, 75}, {160, 55, 105},
                                   {100, 40, 130},  {50, 40, 120},  {20, 25, 80}};
  for (int order = 0; order <= highest_class; ++order)
    classes.push_back({"C^" + std::to_string(order) + (order == highest_class ? " or more" : ""),
                       ramp[static_cast<std::size_t>(order)]});
  return classes;
}

int class_of(const MapCell& cell) {
  if (!cell.valid) return 0;
  if (cell.certified < 0) return cell.refuted_next ? 1 : 2;
  return 3 + std::min(cell.certified, highest_class);
}

void write_png(const std::filesystem::path& path, const std::string& size, const MapRange& x,
               const MapRange& y, const std::vector<MapCell>& cells) {
  int width = 0, height = 0, used = 0;
  if (std::sscanf(size.c_str(), "%dx%d%n", &width, &height, &used) != 2 ||
      static_cast<std::size_t>(used) != size.size())
    throw Misuse("--size '" + size + "' is not of the form 1000x800");
  vtk::ClassMap map{
      {x.name, to_double(x.values.front()), to_double(x.values.back())},
      {y.name, to_double(y.values.front()), to_double(y.values.back())},
      Grid<int>({static_cast<Index>(y.values.size()), static_cast<Index>(x.values.size())}),
      map_classes()};
  std::transform(cells.begin(), cells.end(), map.cells.samples().begin(), class_of);
  vtk::plot_map(map, {width, height}, path);
}
#endif

void draw_map(const MapArguments& a) {
  const std::string form = std::filesystem::path(a.output).extension().string();
  if (form != ".csv" && form != ".png")
    throw Misuse(a.output + ": the format '" + form + "' is not one of .png, .csv");
#ifndef ARETE_HAVE_VTK
  if (form == ".png") throw Failure(a.output + ": this arete was built without VTK; write a .csv");
#endif
  const MapRange x = parse_range(a.x, "--x");
  const MapRange y = parse_range(a.y, "--y");
  const Plane plane(a.scheme, x, y);
  OutputFile output(a.output, "", a.overwrite);
  std::vector<MapCell> cells;
  {
    ProgressBar bar("mapping");
    const double total = static_cast<double>(x.values.size() * y.values.size());
    std::atomic<std::size_t> finished{0};
    // The bar is for one thread; the others only count.
    const auto owner = std::this_thread::get_id();
    cells = smoothness_map(
        x.values, y.values, [&](const Rational& u, const Rational& v) { return plane.mask(u, v); },
        map_options(a.max_power),
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
  stop_if_interrupted();
#ifdef ARETE_HAVE_VTK
  if (form == ".png") write_png(output.temporary(), a.size, x, y, cells);
#endif
  if (form == ".csv") write_csv(output.temporary(), x, y, cells);
  stop_if_interrupted();
  output.commit();
  std::map<int, std::size_t> counts;
  for (const MapCell& cell : cells) ++counts[cell.valid ? cell.certified : -2];
  std::cout << a.scheme << " -> " << a.output << ": " << cells.size() << " points";
  for (const auto& [order, count] : counts)
    std::cout << ", " << count << " "
              << (order == -2   ? "without scheme"
                  : order == -1 ? "not certified"
                                : "C^" + std::to_string(order));
  std::cout << '\n';
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
  verb->add_option("--y", a->y, "The same for the other axis")->required();
  verb->add_option("--max-power", a->max_power, "Highest power of the norms that are tried")
      ->check(CLI::Range(1, 16))
      ->capture_default_str();
  verb->add_option("--size", a->size, "WIDTHxHEIGHT of the picture")->capture_default_str();
  verb->add_flag("--overwrite", a->overwrite, "Replace OUT if it exists");
  verb->callback([&job, a] { job = [a] { draw_map(*a); }; });
}

}  // namespace arete::cli
