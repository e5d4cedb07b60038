// SPDX-License-Identifier: MIT
#include "arete/opensubdiv/catmull_clark.h"

#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

namespace arete::opensubdiv {
namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

constexpr int largest_levels = 10;

// What PrimvarRefinerReal asks of a value.
struct Sample {
  double value = 0;
  void Clear() { value = 0; }
  void AddWithWeight(const Sample& other, double weight) { value += weight * other.value; }
};

struct Place {
  double row = 0;
  double col = 0;
  void Clear() { row = col = 0; }
  void AddWithWeight(const Place& other, double weight) {
    row += weight * other.row;
    col += weight * other.col;
  }
};

void check(const std::vector<GridView<const double>>& planes, int levels) {
  if (planes.empty()) throw InvalidField("Catmull-Clark needs at least one plane of samples");
  const Extent extent = planes.front().extent();
  for (const auto& plane : planes)
    if (plane.extent() != extent) throw InvalidField("the planes of a mesh must have one size");
  if (extent.rows < 2 || extent.cols < 2)
    throw InvalidField("Catmull-Clark needs a quad: give at least 2 x 2 samples, not " +
                       std::to_string(extent.rows) + " x " + std::to_string(extent.cols));
  if (levels < 0 || levels > largest_levels)
    throw InvalidField("levels = " + std::to_string(levels) + "; OpenSubdiv is asked for 0 to " +
                       std::to_string(largest_levels));
  const double vertices = std::ldexp(static_cast<double>(extent.rows), levels) *
                          std::ldexp(static_cast<double>(extent.cols), levels);
  // Four corners a face are numbered too.
  if (vertices > std::numeric_limits<int>::max() / 4.0)
    throw InvalidField("the refined mesh exceeds OpenSubdiv's 32-bit numbering; use fewer levels");
}

std::unique_ptr<Far::TopologyRefiner> make_refiner(Extent extent, int levels, CornerRule corners) {
  const int rows = static_cast<int>(extent.rows);
  const int cols = static_cast<int>(extent.cols);
  const int faces = (rows - 1) * (cols - 1);
  const std::vector<int> face_sizes(static_cast<std::size_t>(faces), 4);
  std::vector<int> face_vertices;
  face_vertices.reserve(static_cast<std::size_t>(4 * faces));
  for (int r = 0; r + 1 < rows; ++r) {
    for (int c = 0; c + 1 < cols; ++c) {
      const int v = r * cols + c;
      face_vertices.insert(face_vertices.end(), {v, v + 1, v + cols + 1, v + cols});
    }
  }
  Far::TopologyDescriptor descriptor;
  descriptor.numVertices = rows * cols;
  descriptor.numFaces = faces;
  descriptor.numVertsPerFace = face_sizes.data();
  descriptor.vertIndicesPerFace = face_vertices.data();

  Sdc::Options options;
  options.SetVtxBoundaryInterpolation(corners == CornerRule::sharp
                                          ? Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER
                                          : Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
  using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
  std::unique_ptr<Far::TopologyRefiner> refiner(
      Factory::Create(descriptor, Factory::Options(Sdc::SCHEME_CATMARK, options)));
  if (!refiner) throw std::runtime_error("OpenSubdiv refused the topology of a plain grid");
  if (levels > 0) refiner->RefineUniform(Far::TopologyRefiner::UniformOptions(levels));
  return refiner;
}

}  // namespace

std::vector<Grid<double>> catmull_clark(const std::vector<GridView<const double>>& planes,
                                        int levels, CornerRule corners) {
  check(planes, levels);
  const Extent extent = planes.front().extent();
  const auto refiner = make_refiner(extent, levels, corners);
  const Far::PrimvarRefinerReal<double> interpolate(*refiner);

  // Where the vertices of the last level lie, in its own rows and columns.
  std::vector<Place> places;
  const double scale = std::ldexp(1.0, levels);
  for (Index r = 0; r < extent.rows; ++r)
    for (Index c = 0; c < extent.cols; ++c)
      places.push_back({scale * static_cast<double>(r), scale * static_cast<double>(c)});
  for (int level = 1; level <= levels; ++level) {
    std::vector<Place> finer(static_cast<std::size_t>(refiner->GetLevel(level).GetNumVertices()));
    interpolate.InterpolateVarying(level, places, finer);
    places = std::move(finer);
  }

  const Extent fine{((extent.rows - 1) << levels) + 1, ((extent.cols - 1) << levels) + 1};
  std::vector<Grid<double>> results;
  for (const auto& plane : planes) {
    std::vector<Sample> samples;
    for (Index r = 0; r < extent.rows; ++r)
      for (Index c = 0; c < extent.cols; ++c) samples.push_back({plane(r, c)});
    for (int level = 1; level <= levels; ++level) {
      std::vector<Sample> finer(
          static_cast<std::size_t>(refiner->GetLevel(level).GetNumVertices()));
      interpolate.Interpolate(level, samples, finer);
      samples = std::move(finer);
    }
    // A sample that no vertex fills stays a NaN.
    Grid<double>& grid = results.emplace_back(fine, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t v = 0; v < samples.size(); ++v)
      grid(std::lround(places[v].row), std::lround(places[v].col)) = samples[v].value;
  }
  return results;
}

Grid<double> catmull_clark(const Grid<double>& heights, int levels, CornerRule corners) {
  return std::move(catmull_clark({heights.view()}, levels, corners).front());
}

}  // namespace arete::opensubdiv
