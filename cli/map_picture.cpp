// SPDX-License-Identifier: MIT
#include "cli/map_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "arete/vtk/plot_functions.h"
#include "arete/vtk/plot_map.h"
#include "cli/error.h"

namespace arete::cli {
namespace {

constexpr int highest_order = 6;
// Classes before the ramp: no scheme, does not converge, undecided.
constexpr int first_class = 3;

std::vector<vtk::MapClass> first_classes() {
  return {{"no scheme", {255, 255, 255}},
          {"does not converge", {60, 60, 66}},
          {"convergence undecided", {190, 190, 190}}};
}

// From warm (rough) to cold (smooth); readable without colour by its falling lightness.
vtk::Rgb ramp(double share) {
  static const std::vector<vtk::Rgb> colors{{250, 214, 140}, {240, 160, 80}, {215, 95, 75},
                                            {160, 55, 105},  {100, 40, 130}, {50, 40, 120},
                                            {20, 25, 80}};
  const double at = std::clamp(share, 0.0, 1.0) * static_cast<double>(colors.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(at), colors.size() - 2);
  vtk::Rgb mixed{};
  for (std::size_t i = 0; i < 3; ++i)
    mixed[i] = static_cast<unsigned char>(std::lround(
        colors[low][i] + (at - static_cast<double>(low)) * (colors[low + 1][i] - colors[low][i])));
  return mixed;
}

vtk::Rgb paler(const vtk::Rgb& color) {
  vtk::Rgb mixed{};
  for (std::size_t i = 0; i < 3; ++i) mixed[i] = static_cast<unsigned char>((color[i] + 255) / 2);
  return mixed;
}

// Two classes an order: the next order refuted, or not decided (paler).
std::vector<vtk::MapClass> order_classes() {
  std::vector<vtk::MapClass> classes = first_classes();
  for (int order = 0; order <= highest_order; ++order) {
    const std::string name = "C^" + std::to_string(order);
    const vtk::Rgb color = ramp(static_cast<double>(order) / highest_order);
    classes.push_back({order == highest_order ? name + " or more" : name + " and no more", color});
    classes.push_back({name + ", more undecided", paler(color)});
  }
  return classes;
}

int order_class(const MapCell& cell) {
  if (!cell.valid) return 0;
  if (cell.certified < 0) return cell.refuted_next ? 1 : 2;
  const int order = std::min(cell.certified, highest_order);
  const bool sharp = cell.refuted_next || order == highest_order;
  return first_class + 2 * order + (sharp ? 0 : 1);
}

// Steps of a quarter, of a half or of one, so that there are at most a dozen.
struct ExponentBins {
  double step = 0.25;
  int count = 1;

  explicit ExponentBins(const std::vector<MapCell>& cells) {
    double most = 0;
    for (const MapCell& cell : cells)
      if (cell.valid) most = std::max(most, cell.hoelder_lower);
    while (most / step > 12) step *= 2;
    count = std::max(1, static_cast<int>(std::floor(most / step)) + 1);
  }

  [[nodiscard]] std::vector<vtk::MapClass> classes() const {
    std::vector<vtk::MapClass> all = first_classes();
    for (int bin = 0; bin < count; ++bin) {
      char label[48];
      std::snprintf(label, sizeof label, "exponent >= %g", bin * step);
      all.push_back({bin == 0 ? "exponent > 0" : label,
                     ramp(static_cast<double>(bin) / std::max(1, count - 1))});
    }
    return all;
  }
  [[nodiscard]] int class_of(const MapCell& cell) const {
    if (!cell.valid || cell.certified < 0) return order_class(cell);
    return first_class + std::max(0, static_cast<int>(std::floor(cell.hoelder_lower / step)));
  }
};

// Over one parameter the exponent's bound is a function; where no convergence is proved it is 0.
void draw_exponents(const MapPicture& picture, std::array<int, 2> size,
                    const std::filesystem::path& png) {
  vtk::FunctionGraph graph{"Hoelder exponent, proved lower bound",
                           Grid<double>({picture.x.count(), 2})};
  for (Index i = 0; i < picture.x.count(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const MapCell& cell = picture.cells[at];
    graph.points(i, 0) = to_double(picture.x.values[at]);
    graph.points(i, 1) = cell.valid && cell.certified >= 0 ? cell.hoelder_lower : 0;
  }
  vtk::plot_functions({graph}, picture.x.name, size, png);
}

// `theorem 1 (Zhao, Peng, Ye), C^0` -> `theorem 1, C^0`
std::string without_authors(std::string name) {
  const auto open = name.find(" (");
  const auto close = name.find(')', open == std::string::npos ? 0 : open);
  if (open != std::string::npos && close != std::string::npos) name.erase(open, close + 1 - open);
  return name;
}

}  // namespace

std::array<int, 2> picture_size(const std::string& text, const MapRange& y) {
  if (text.empty()) return y.keys.empty() ? std::array{1000, 300} : std::array{1000, 800};
  int width = 0, height = 0, used = 0;
  if (std::sscanf(text.c_str(), "%dx%d%n", &width, &height, &used) != 2 ||
      static_cast<std::size_t>(used) != text.size())
    throw Misuse("--size '" + text + "' is not of the form 1000x800");
  return {width, height};
}

void draw_map_picture(const MapPicture& picture, std::array<int, 2> size,
                      const std::filesystem::path& png) {
  const MapRange& x = picture.x;
  const MapRange& y = picture.y;
  if (picture.hoelder && y.keys.empty() && x.count() > 1) {
    draw_exponents(picture, size, png);
    return;
  }
  vtk::ClassMap map{{x.name, to_double(x.values.front()), to_double(x.values.back())},
                    {y.name, to_double(y.values.front()), to_double(y.values.back())},
                    Grid<int>({y.count(), x.count()}),
                    {},
                    {}};
  if (picture.hoelder) {
    const ExponentBins bins(picture.cells);
    map.classes = bins.classes();
    std::transform(picture.cells.begin(), picture.cells.end(), map.cells.samples().begin(),
                   [&](const MapCell& cell) { return bins.class_of(cell); });
  } else {
    map.classes = order_classes();
    std::transform(picture.cells.begin(), picture.cells.end(), map.cells.samples().begin(),
                   order_class);
  }
  const std::array<vtk::Rgb, 5> inks{
      vtk::Rgb{0, 0, 0}, {0, 110, 220}, {0, 140, 60}, {200, 0, 150}, {120, 80, 0}};
  for (std::size_t i = 0; i < picture.regions.size(); ++i) {
    const PrintedRegion& region = picture.regions[i];
    const std::string label = without_authors(region.name);
    const vtk::Rgb& ink = inks[i % inks.size()];
    if (region.extent == PrintedRegion::Extent::inside)
      map.outlines.push_back({label, ink, region.margin, {}});
    if (region.extent == PrintedRegion::Extent::line)
      map.outlines.push_back({label, ink, region.equality, region.margin});
  }
  vtk::plot_map(map, size, png);
}

}  // namespace arete::cli
