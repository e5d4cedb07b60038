// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "arete/gdal/error.h"

class OGRSpatialReference;

namespace arete::gdal {

/// A reference system as WKT; empty for none.
[[nodiscard]] std::string wkt_of(const OGRSpatialReference* reference);

/// A reference system as WKT from what users write: EPSG:32633, WKT, PROJ text, ...
/// \throws RasterError if GDAL does not know it.
[[nodiscard]] std::string crs_from_text(const std::string& text);

/// Whether the coordinates of that system (WKT) are degrees.
[[nodiscard]] bool is_geographic(const std::string& crs);

/// Whether two systems (WKT) are the same, whatever their names and axis order.
[[nodiscard]] bool same_crs(const std::string& first, const std::string& second);

}  // namespace arete::gdal
