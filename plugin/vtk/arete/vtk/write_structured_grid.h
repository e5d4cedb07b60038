// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "arete/vtk/surface.h"
#include "arete/vtk/write_options.h"

namespace arete::vtk {

/// Writes a surface as a VTK structured grid (.vts): every sample a point in space, with the point
/// arrays "height" (active scalars, type of the heights), "slope" (float, degrees from level) and
/// "Normals" (active normals, float, upward).
///
/// Points are double and lie at world coordinates, or in local metres for a geographic surface
/// (see surface.h). Rows are taken in the order that makes cells counter-clockwise seen from above
/// (last first for a north-up raster). Missing samples have height and slope NaN, lie at the lowest
/// height, and are hidden by a "vtkGhostType" array if there are any (vtkGeometryFilter and
/// ParaView leave the cells around them out; the older vtkDataSetSurfaceFilter does not). Field
/// data: "CRS_WKT", "GeoTransform", "local_plane" (geographic only), and the notes. \throws
/// InvalidField see check_geometry. \throws WriteError
void write_structured_grid(const Surface& surface, const std::filesystem::path& path,
                           const WriteOptions& options = {});

}  // namespace arete::vtk
