// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "arete/gdal/refine_raster.h"
#include "cli/progress.h"

namespace arete::cli {

/// One band of a raster refined in memory and written as a mesh of quads: .obj, .ply or .off with
/// texture coordinates that put an image of the raster's bounding box upon it, or .stl.
///
/// Vertices lie where a .vtp of the same raster has them: in the raster's own plane, or for
/// longitudes and latitudes in metres around its centre (field/local_plane.h; a comment in the file
/// says so). A quad needs four valid samples; samples without a quad are left out. Faces look up.
/// `format` is the extension without its dot. \throws Failure if it would take more than
/// max_memory.
gdal::RasterReport refine_to_mesh(const gdal::Raster& input, int band,
                                  const std::filesystem::path& output, const std::string& format,
                                  const Scheme& x, const Scheme& y, const RefineOptions& options,
                                  gdal::SampleType type, double max_memory, ProgressBar& progress);

}  // namespace arete::cli
