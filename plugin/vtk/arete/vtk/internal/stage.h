// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <utility>

#include "arete/vtk/internal/local_plane.h"

namespace arete::vtk {

using Vector3 = std::array<double, 3>;

/// A surface set up to be drawn: about the raster's centre, so that single precision is enough for
/// OpenGL, and stretched upwards.
class Stage {
 public:
  /// Heights are counted from `middle`. Borrows the surface.
  Stage(const Surface& surface, LocalPlane plane, double middle, double exaggeration)
      : surface_(surface),
        plane_(std::move(plane)),
        middle_(middle),
        exaggeration_(exaggeration),
        centre_(plane_.placement.position(static_cast<double>(surface.extent().rows - 1) / 2,
                                          static_cast<double>(surface.extent().cols - 1) / 2)) {}

  [[nodiscard]] const Surface& surface() const { return surface_; }
  [[nodiscard]] const LocalPlane& plane() const { return plane_; }
  [[nodiscard]] double exaggeration() const { return exaggeration_; }

  /// Where a height above the sample (row, col) stands.
  [[nodiscard]] Vector3 place(Index row, Index col, double height) const {
    const WorldPoint at =
        plane_.placement.position(static_cast<double>(row), static_cast<double>(col));
    return {at.x - centre_.x, at.y - centre_.y, (height - middle_) * exaggeration_};
  }
  [[nodiscard]] Vector3 place(Index row, Index col) const {
    return place(row, col, surface_.height(row, col));
  }

 private:
  const Surface& surface_;
  LocalPlane plane_;
  double middle_;
  double exaggeration_;
  WorldPoint centre_;
};

}  // namespace arete::vtk
