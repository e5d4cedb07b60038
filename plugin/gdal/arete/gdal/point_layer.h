// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "arete/gdal/error.h"

namespace arete::gdal {

/// The points of a vector layer.
struct PointLayer {
  std::vector<double> x, y, z;
  std::string crs;  ///< WKT; empty when the layer has none
};

/// Reads a layer of points (or multipoints) of any vector format that GDAL knows: GeoPackage,
/// shapefile, GeoJSON, ... Heights are the points' z, or the numbers of the field `height_field`; a
/// feature without geometry, or whose field is not set, is passed over.
///
/// `layer` names one of several layers; empty: the only one.
/// \throws RasterError if the file cannot be read or has no such layer or field, a geometry is no
/// point, points have no z and no field is named, or there are no points.
[[nodiscard]] PointLayer read_points(const std::string& path, const std::string& layer,
                                     const std::string& height_field);

}  // namespace arete::gdal
