// SPDX-License-Identifier: GPL-3.0-or-later
#include "arete/meshlab/terrain_from_points.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "arete/field/error.h"
#include "arete/meshlab/cell_cut.h"
#include "arete/meshlab/memory.h"
#include "arete/meshlab/plan_grid.h"

namespace arete::meshlab {
namespace {

// The vertices as the gridding wants them.
struct Columns {
  std::vector<double> x, y, z;

  explicit Columns(const MeshArrays& mesh) {
    for (const Point3& p : mesh.positions) {
      x.push_back(p[0]);
      y.push_back(p[1]);
      z.push_back(p[2]);
    }
  }
};

class FromPoints {
 public:
  FromPoints(const MeshArrays& mesh, const FromPointsOptions& options, Report& report)
      : mesh_(mesh),
        options_(options),
        report_(report),
        grid_(plan_grid(mesh.positions, options.spacing)),
        points_(mesh) {
    const double nodes = static_cast<double>(grid_.extent.rows * grid_.extent.cols);
    check_memory(350 * static_cast<double>(mesh.positions.size()) + 400 * nodes, nodes);
  }

  [[nodiscard]] CreatedMesh made() {
    const Grid<double> heights = options_.method ? gridded_heights() : heights_of_faces();
    CreatedMesh result;
    result.label = "Terrain from points";
    const std::vector<int> numbers = add_cells(heights, result.arrays);
    result.arrays.positions.reserve(numbers.size());
    for (Index r = 0; r < grid_.extent.rows; ++r)
      for (Index c = 0; c < grid_.extent.cols; ++c)
        if (numbers[node(r, c)] >= 0)
          result.arrays.positions.push_back({grid_.x(c), grid_.y(r), heights(r, c)});
    add_channels(numbers, result.arrays);
    report_.log("A grid of " + std::to_string(grid_.extent.rows) + " x " +
                std::to_string(grid_.extent.cols) + " vertices, " + std::to_string(grid_.spacing) +
                " apart");
    const std::size_t gaps = numbers.size() - result.arrays.positions.size();
    if (gaps > 0)
      report_.log(std::to_string(gaps) +
                  " of them are left out; a terrain with gaps cannot be subdivided");
    return result;
  }

 private:
  [[nodiscard]] std::size_t node(Index r, Index c) const {
    return static_cast<std::size_t>(r * grid_.extent.cols + c);
  }

  // Values of the vertices at the nodes; progress runs from `begin` to `end` percent.
  [[nodiscard]] cgal::GriddedPoints gridded(const std::vector<double>& values,
                                            cgal::GridRequest request, int begin, int end) const {
    request.size = grid_.extent;
    const double last_row = static_cast<double>(grid_.extent.rows - 1);
    const double last_col = static_cast<double>(grid_.extent.cols - 1);
    request.box = cgal::PlaneBox{grid_.west, grid_.south, grid_.west + last_col * grid_.spacing,
                                 grid_.south + last_row * grid_.spacing};
    request.progress = [&](double share) {
      report_.progress(begin + static_cast<int>(share * (end - begin)), "Gridding");
    };
    return cgal::grid_points({points_.x, points_.y, values}, request);
  }

  static cgal::GridRequest linear(cgal::OutsideHull outside) {
    cgal::GridRequest request;
    request.method = cgal::GridMethod::linear;
    request.outside = outside;
    return request;
  }

  [[nodiscard]] Grid<double> gridded_heights() const {
    cgal::GridRequest request;
    request.method = *options_.method;
    request.outside = options_.outside;
    if (options_.drop_outliers > 0) request.drop_outliers = options_.drop_outliers;
    cgal::GriddedPoints result = gridded(points_.z, request, 0, 60);
    report_.log(std::to_string(result.used) + " different points of " +
                std::to_string(result.given) + " make the terrain");
    if (result.not_finite > 0)
      report_.log(std::to_string(result.not_finite) +
                  " points with a coordinate that is not a finite number were passed over");
    if (result.outliers > 0)
      report_.log(std::to_string(result.outliers) + " points were dropped as outliers");
    if (result.covered > 0)
      report_.log("It passes by the points at " + std::to_string(result.rmse) +
                  " (root mean square), at most " + std::to_string(result.largest_error));
    return std::move(result.heights);
  }

  [[nodiscard]] Grid<double> heights_of_faces() const {
    if (mesh_.triangles.empty())
      throw InvalidField("the mesh has no triangles of its own; choose another method");
    report_.progress(10, "Reading heights of the triangles");
    Grid<double> heights = heights_of_triangles(mesh_, grid_);
    auto& samples = heights.samples();
    const auto open =
        std::count_if(samples.begin(), samples.end(), [](double z) { return std::isnan(z); });
    report_.log(std::to_string(mesh_.triangles.size()) + " triangles make the terrain");
    if (open == 0 || options_.outside == cgal::OutsideHull::nodata) return heights;
    report_.log(std::to_string(open) +
                " vertices of the grid lie beside them and are filled from the vertices around");
    const Grid<double> others = gridded(points_.z, linear(options_.outside), 20, 60).heights;
    for (std::size_t i = 0; i < samples.size(); ++i)
      if (std::isnan(samples[i])) samples[i] = others.samples()[i];
    return heights;
  }

  // The cells with four heights; returns the number of every node's vertex, -1 if it has none.
  std::vector<int> add_cells(const Grid<double>& heights, MeshArrays& arrays) const {
    const Extent extent = grid_.extent;
    std::vector<bool> complete(heights.samples().size(), false);
    std::vector<int> numbers(heights.samples().size(), -1);
    const auto is_there = [&](Index r, Index c) { return std::isfinite(heights(r, c)); };
    for (Index r = 0; r + 1 < extent.rows; ++r)
      for (Index c = 0; c + 1 < extent.cols; ++c) {
        if (!is_there(r, c) || !is_there(r, c + 1) || !is_there(r + 1, c) ||
            !is_there(r + 1, c + 1))
          continue;
        complete[node(r, c)] = true;
        for (const std::size_t n : {node(r, c), node(r, c + 1), node(r + 1, c), node(r + 1, c + 1)})
          numbers[n] = 0;
      }
    int next = 0;
    for (int& number : numbers)
      if (number == 0) number = next++;
    if (next == 0)
      throw InvalidField(
          "no cell of the grid has heights at all four corners; choose a smaller spacing, or "
          "another choice than leaving out what lies outside");
    for (Index r = 0; r + 1 < extent.rows; ++r)
      for (Index c = 0; c + 1 < extent.cols; ++c) {
        if (!complete[node(r, c)]) continue;
        const std::array<int, 4> corners{numbers[node(r, c)], numbers[node(r, c + 1)],
                                         numbers[node(r + 1, c + 1)], numbers[node(r + 1, c)]};
        // Counter-clockwise from above: faces look up.
        for (const CellCut& cut : cell_cuts(true, Diagonal::main)) {
          Triangle& triangle = arrays.triangles.emplace_back();
          for (std::size_t k = 0; k < 3; ++k)
            triangle[k] = corners[static_cast<std::size_t>(cut.corners[k])];
          arrays.inner_edges.push_back(cut.inner_edge);
        }
      }
    return numbers;
  }

  void add_channels(const std::vector<int>& numbers, MeshArrays& arrays) const {
    for (const Channel& channel : mesh_.channels) {
      Channel& result = arrays.channels.emplace_back();
      result.blend = channel.blend;
      const float first = channel.values.front();
      if (std::all_of(channel.values.begin(), channel.values.end(),
                      [&](float value) { return value == first; })) {
        result.values.assign(arrays.positions.size(), first);
        continue;
      }
      const Grid<double> values = gridded({channel.values.begin(), channel.values.end()},
                                          linear(cgal::OutsideHull::nearest), 60, 85)
                                      .heights;
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (numbers[i] < 0) continue;
        const double value = values.samples()[i];
        result.values.push_back(
            static_cast<float>(channel.blend == Blend::nearest ? std::round(value) : value));
      }
    }
  }

  const MeshArrays& mesh_;
  const FromPointsOptions& options_;
  Report& report_;
  PlanGrid grid_;
  Columns points_;
};

}  // namespace

CreatedMesh terrain_from_points(const MeshArrays& mesh, const FromPointsOptions& options,
                                Report& report) {
  report.progress(0, "Placing the grid");
  return FromPoints(mesh, options, report).made();
}

}  // namespace arete::meshlab
