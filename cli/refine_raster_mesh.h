// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "arete/gdal/refine_raster.h"
#include "cli/detail_statistics.h"
#include "cli/progress.h"

namespace arete::cli {

/// What the mesh of a raster has become.
struct RasterMesh {
  gdal::RasterReport raster;
  Index vertices = 0;
  Index quads = 0;
  Index triangles = 0;
  /// The largest vertical distance of a refined sample from the triangle over or under it, in units
  /// of the heights; 0 for quads, whose corners are all samples.
  double largest_error = 0;
  Index left_out = 0;       ///< valid samples that no face holds
  DetailStatistics detail;  ///< if there is any detail
};

/// One band of a raster refined in memory and written as a mesh of quads: .obj, .ply or .off with
/// texture coordinates that put an image of the raster's bounding box upon it, .vtp
/// likewise, .stl, or .png or .jpg, a map of the edges (triangles_picture.h). If the quads make
/// more than `most_triangles` (two a quad), it is written as at most so many triangles between
/// refined samples instead (topology/height_triangles.h).
///
/// Vertices lie where a .vtp of the same raster has them: in the raster's own plane, or for
/// longitudes and latitudes in metres around its centre (field/local_plane.h; a comment in the file
/// says so). A quad needs four valid samples; samples without a face are left out. Faces look up.
/// `format` is the extension without its dot. \throws Failure if it would take more than
/// max_memory.
RasterMesh refine_to_mesh(const gdal::Raster& input, int band, const std::filesystem::path& output,
                          const std::string& format, const Scheme& x, const Scheme& y,
                          const RefineOptions& options, gdal::SampleType type,
                          std::optional<Index> most_triangles, double max_memory,
                          ProgressBar& progress);

}  // namespace arete::cli
