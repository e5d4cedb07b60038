// SPDX-License-Identifier: MIT
#include "arete/vtk/surface.h"

#include <algorithm>
#include <cmath>

#include "arete/field/local_plane.h"

namespace arete::vtk {
namespace {

std::string size_text(Extent extent) {
  return std::to_string(extent.rows) + " x " + std::to_string(extent.cols);
}

bool any_valid(const Surface& surface) {
  const Extent extent = surface.extent();
  for (Index r = 0; r < extent.rows; ++r) {
    for (Index c = 0; c < extent.cols; ++c) {
      if (surface.valid(r, c)) return true;
    }
  }
  return false;
}

}  // namespace

Extent Surface::extent() const {
  return std::visit([](const auto& view) { return view.extent(); }, heights);
}

double Surface::height(Index row, Index col) const {
  return std::visit([=](const auto& view) { return static_cast<double>(view(row, col)); }, heights);
}

bool Surface::valid(Index row, Index col) const { return std::isfinite(height(row, col)); }

void check_samples(const Surface& surface) {
  const Extent extent = surface.extent();
  if (extent.rows < 1 || extent.cols < 1) {
    throw InvalidField("a surface of " + size_text(extent) + " has no samples");
  }
  if (surface.gradients) {
    for (const auto& view : {surface.gradients->dz_dx, surface.gradients->dz_dy}) {
      if (view.extent() != extent) {
        throw InvalidField("gradients of " + size_text(view.extent()) + " do not fit heights of " +
                           size_text(extent) + "; give one pair a sample, or none");
      }
    }
  }
  const auto& g = surface.georeference.affine;
  if (!std::all_of(g.begin(), g.end(), [](double value) { return std::isfinite(value); })) {
    throw InvalidField("the georeference holds a number that is not finite");
  }
  for (const Note& note : surface.notes) {
    if (note.name.empty()) throw InvalidField("a note without a name cannot be kept in a file");
  }
}

void check_geometry(const Surface& surface) {
  check_samples(surface);
  const Extent extent = surface.extent();
  if (extent.rows < 2 || extent.cols < 2) {
    throw InvalidField("a surface needs at least 2 x 2 samples, this one has " + size_text(extent));
  }
  const auto& g = surface.georeference.affine;
  const double area = g[1] * g[5] - g[2] * g[4];
  if (!(std::abs(area) > 1e-12 * std::hypot(g[1], g[4]) * std::hypot(g[2], g[5]))) {
    throw InvalidField("the georeference maps the raster onto a line; give it two directions");
  }
  (void)local_plane(surface.georeference, extent, surface.coordinates == Coordinates::geographic);
  if (!any_valid(surface)) throw InvalidField("no sample of this surface is valid");
}

}  // namespace arete::vtk
