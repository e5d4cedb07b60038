// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "arete/cgal/internal/local_points.h"
#include "arete/cgal/scattered_grid.h"

namespace arete::cgal {
namespace {

constexpr std::array<std::pair<std::string_view, GridMethod>, 4> methods{
    {{"natural-neighbour", GridMethod::natural_neighbour},
     {"linear", GridMethod::linear},
     {"idw", GridMethod::inverse_distance},
     {"natural-neighbor", GridMethod::natural_neighbour}}};

constexpr std::array<std::pair<std::string_view, OutsideHull>, 3> outsides{
    {{"nodata", OutsideHull::nodata},
     {"nearest", OutsideHull::nearest},
     {"extrapolate", OutsideHull::extrapolate}}};

template <class Table>
auto parse(const Table& table, std::string_view text, const std::string& remedy) {
  for (const auto& [name, value] : table)
    if (name == text) return value;
  throw InvalidField("there is no " + remedy + " (got '" + std::string(text.substr(0, 64)) + "')");
}

template <class Table, class Value>
std::string_view name_of(const Table& table, Value value) {
  for (const auto& [name, other] : table)
    if (other == value) return name;
  return "";
}

// What a width may lack of a whole number of steps and still hold them: what rounding takes from
// coordinates of this size.
double slack(double low, double high, double step) {
  return 1e-9 + 8 * std::numeric_limits<double>::epsilon() *
                    std::max(std::abs(low), std::abs(high)) / step;
}

// How many samples `step` apart fit between two coordinates.
double count_of(double low, double high, double step) {
  return std::floor((high - low) / step + slack(low, high, step)) + 1;
}

// The last of them; on the far edge to the last bit if that is where it belongs.
double last_of(double low, double high, double step, double count) {
  const double reached = low + (count - 1) * step;
  return std::abs(reached - high) <= slack(low, high, step) * step ? high : reached;
}

PlaneBox box_of(const ScatteredPoints& points, const GridRequest& request) {
  const PlaneBox own = detail::bounding_box(points);
  if (!request.box) return own;
  const PlaneBox& box = *request.box;
  for (const double edge : {box.x_min, box.y_min, box.x_max, box.y_max})
    if (!std::isfinite(edge)) throw InvalidField("an edge of the box is not a finite number");
  if (box.x_min > box.x_max || box.y_min > box.y_max)
    throw InvalidField("the box is empty; give its smallest x and y first, then the largest");
  return box;
}

}  // namespace

GridMethod parse_grid_method(std::string_view text) {
  return parse(methods, text, "such method; choose natural-neighbour, linear or idw");
}

OutsideHull parse_outside(std::string_view text) {
  return parse(outsides, text, "such outside rule; choose nodata, nearest or extrapolate");
}

std::string_view to_string(GridMethod method) { return name_of(methods, method); }
std::string_view to_string(OutsideHull outside) { return name_of(outsides, outside); }

GridPlace place_grid(const ScatteredPoints& points, const GridRequest& request) {
  if (request.spacing.has_value() == request.size.has_value())
    throw InvalidField("give either the spacing or the size of the grid");
  const PlaneBox box = box_of(points, request);
  const double width = box.x_max - box.x_min;
  const double height = box.y_max - box.y_min;
  WorldPoint step;
  double cols = 0;
  double rows = 0;
  if (request.size) {
    if (request.size->rows < 2 || request.size->cols < 2)
      throw InvalidField("a grid of " + std::to_string(request.size->cols) + " x " +
                         std::to_string(request.size->rows) +
                         " samples has no spacing; give at least 2 x 2");
    if (!(width > 0 && height > 0))
      throw InvalidField(
          "the points' bounding box has no area, so that a size says nothing of the spacing; give "
          "a spacing or a box");
    cols = static_cast<double>(request.size->cols);
    rows = static_cast<double>(request.size->rows);
    step = {width / (cols - 1), height / (rows - 1)};
  } else {
    step = *request.spacing;
    if (!(step.x > 0 && step.y > 0 && std::isfinite(step.x) && std::isfinite(step.y)))
      throw InvalidField("the spacing must be a positive number");
    cols = count_of(box.x_min, box.x_max, step.x);
    rows = count_of(box.y_min, box.y_max, step.y);
  }
  if (!(cols * rows < 2147483648.0))
    throw InvalidField(
        "the grid would have more than 2^31 - 1 samples; take a larger spacing, or a box if a "
        "point lies far away from the others");
  // Steps that coordinates of this size cannot tell apart would put samples in one place.
  const double largest = std::max(
      {std::abs(box.x_min), std::abs(box.x_max), std::abs(box.y_min), std::abs(box.y_max)});
  if (std::min(step.x, step.y) < 1e-14 * largest)
    throw InvalidField(
        "the spacing is below what coordinates of this size can tell apart; take a larger one");
  GridPlace place;
  place.extent = {static_cast<Index>(rows), static_cast<Index>(cols)};
  place.spacing = step;
  place.box = {box.x_min, box.y_min, last_of(box.x_min, box.x_max, step.x, cols),
               last_of(box.y_min, box.y_max, step.y, rows)};
  place.georeference = {
      {box.x_min - step.x / 2, step.x, 0, place.box.y_max + step.y / 2, 0, -step.y},
      Registration::point};
  return place;
}

}  // namespace arete::cgal
