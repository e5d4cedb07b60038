// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "arete/vtk/surface.h"

namespace arete::vtk {

/// The plane in which geometry is built: lengths in both directions, whatever the coordinates of
/// the surface are. Identity for planar surfaces; see surface.h for geographic ones.
struct LocalPlane {
  WorldPoint origin{};  ///< world coordinates of the plane's (0, 0)
  double scale_x = 1;   ///< plane units per world unit
  double scale_y = 1;
  Georeference placement{};  ///< where samples lie in the plane

  /// What a reader of the file has to know; empty for planar surfaces.
  std::string note{};
};

/// \pre check_geometry(surface) has passed.
[[nodiscard]] LocalPlane local_plane(const Surface& surface);

}  // namespace arete::vtk
