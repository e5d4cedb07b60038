// SPDX-License-Identifier: MIT
#pragma once

#include "arete/field/local_plane.h"
#include "arete/vtk/surface.h"

namespace arete::vtk {

using arete::LocalPlane;

/// The plane in which the geometry of a surface is built; see surface.h for geographic ones.
/// \pre check_geometry(surface) has passed.
[[nodiscard]] inline LocalPlane local_plane(const Surface& surface) {
  return arete::local_plane(surface.georeference, surface.extent(),
                            surface.coordinates == Coordinates::geographic);
}

}  // namespace arete::vtk
