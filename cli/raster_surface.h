// SPDX-License-Identifier: MIT
#pragma once

#include "arete/gdal/raster.h"
#include "arete/vtk/surface.h"

namespace arete::cli {

/// The surface of heights that came from a raster, at the place given; the heights stay where they
/// are.
template <class T>
[[nodiscard]] vtk::Surface raster_surface(const gdal::Raster& raster, const Georeference& place,
                                          GridView<const T> heights) {
  vtk::Surface surface{heights};
  surface.georeference = place;
  surface.crs_wkt = raster.crs();
  surface.coordinates =
      raster.geographic() ? vtk::Coordinates::geographic : vtk::Coordinates::planar;
  return surface;
}

}  // namespace arete::cli
