// SPDX-License-Identifier: MIT
#pragma once

#include "arete/gdal/raster.h"

namespace arete::cli {

/// The band with that number (from 1). \throws Misuse if there is none.
[[nodiscard]] const gdal::BandInfo& find_band(const gdal::Raster& raster, int number);

}  // namespace arete::cli
