// SPDX-License-Identifier: MIT
#include "arete/gdal/reference_system.h"

#include <cpl_conv.h>
#include <ogr_spatialref.h>

#include <array>

namespace arete::gdal {

std::string wkt_of(const OGRSpatialReference* reference) {
  if (reference == nullptr) return {};
  char* text = nullptr;
  const char* const options[] = {"FORMAT=WKT2_2019", nullptr};
  std::string wkt;
  if (reference->exportToWkt(&text, options) == OGRERR_NONE && text != nullptr) wkt = text;
  CPLFree(text);
  return wkt;
}

std::string crs_from_text(const std::string& text) {
  const ErrorCollector errors;
  OGRSpatialReference reference;
  if (reference.SetFromUserInput(text.c_str()) != OGRERR_NONE)
    throw RasterError("'" + text + "' is no reference system that GDAL knows" +
                      (errors.failed() ? " (" + errors.message() + ")" : "") +
                      "; give e.g. EPSG:32633");
  return wkt_of(&reference);
}

bool is_geographic(const std::string& crs) {
  OGRSpatialReference reference;
  return reference.importFromWkt(crs.c_str()) == OGRERR_NONE && reference.IsGeographic() != 0;
}

bool same_crs(const std::string& first, const std::string& second) {
  OGRSpatialReference a;
  OGRSpatialReference b;
  if (a.importFromWkt(first.c_str()) != OGRERR_NONE ||
      b.importFromWkt(second.c_str()) != OGRERR_NONE)
    return first == second;
  const std::array<const char*, 3> options{"IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES",
                                           "CRITERION=EQUIVALENT_EXCEPT_AXIS_ORDER_GEOGCRS",
                                           nullptr};
  return a.IsSame(&b, options.data()) != 0;
}

}  // namespace arete::gdal
