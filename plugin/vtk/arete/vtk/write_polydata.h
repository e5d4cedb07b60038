// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "arete/vtk/surface.h"
#include "arete/vtk/write_options.h"

namespace arete::vtk {

/// Writes a surface as a VTK polygon mesh (.vtp): the quads whose four corners are all valid,
/// counter-clockwise seen from above, with the same points and point arrays as a .vts (see
/// write_structured_grid.h). Ids are 32 bits wide where they fit.
///
/// Points are in the raster's order, row 0 first. Those that no quad uses are DROPPED: missing
/// samples, and also valid ones without a whole quad around them (a single row between two missing
/// ones, say). A .vti or .vts keeps every sample.
/// \throws InvalidField see check_geometry; also when not a single quad is whole.
/// \throws WriteError
void write_polydata(const Surface& surface, const std::filesystem::path& path,
                    const WriteOptions& options = {});

}  // namespace arete::vtk
