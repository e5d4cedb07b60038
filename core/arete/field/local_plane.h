// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "arete/field/georeference.h"

namespace arete {

/// The plane in which the geometry of a raster is built: lengths in both directions, whatever its
/// coordinates are.
///
/// Coordinates that are lengths stay as they are. Longitudes and latitudes become metres east and
/// north of the raster's centre (lon0, lat0) on the sphere of radius R = 6371008.8 m,
///
///     x = R cos(lat0) (lon - lon0),   y = R (lat - lat0)     (angles in radians),
///
/// right to first order only: over a few hundred kilometres, or near a pole, project the raster.
struct LocalPlane {
  WorldPoint origin{};  ///< world coordinates of the plane's (0, 0)
  double scale_x = 1;   ///< plane units per world unit
  double scale_y = 1;
  Georeference placement{};  ///< where samples lie in the plane

  /// What a reader of the file has to know; empty where coordinates stay as they are.
  std::string note{};
};

/// \throws InvalidField for a geographic raster whose centre lies at or beyond a pole.
[[nodiscard]] LocalPlane local_plane(const Georeference& place, Extent extent, bool geographic);

}  // namespace arete
