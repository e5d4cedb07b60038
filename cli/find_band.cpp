// SPDX-License-Identifier: MIT
#include "cli/find_band.h"

#include <string>

#include "cli/error.h"

namespace arete::cli {

const gdal::BandInfo& find_band(const gdal::Raster& raster, int number) {
  for (const gdal::BandInfo& band : raster.bands())
    if (band.number == number) return band;
  throw Misuse(raster.path() + " has no data band " + std::to_string(number) + "; it has " +
               std::to_string(raster.bands().size()));
}

}  // namespace arete::cli
