// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "arete/gdal/raster.h"
#include "arete/vtk/appearance.h"

namespace arete::cli {

/// The picture at `path` over samples that lie at `place` among those of the raster: by
/// georeference where both have one, stretched over the whole otherwise or when asked for.
/// \throws gdal::RasterError
[[nodiscard]] vtk::Texture drape(const std::string& path, const gdal::Raster& raster,
                                 const Georeference& place, Extent extent, bool stretch);

}  // namespace arete::cli
