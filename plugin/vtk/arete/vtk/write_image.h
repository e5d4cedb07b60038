// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "arete/vtk/surface.h"
#include "arete/vtk/write_options.h"

namespace arete::vtk {

/// Writes a surface as a VTK image (.vti): the smallest and fastest of the three forms, with the
/// heights as active point scalars "height" for the reader to warp.
///
/// Origin and spacing are those of the samples in the raster's own reference system (degrees stay
/// degrees). VTK's j runs up: the rows of a north-up raster are written last first. A rotated
/// raster gets a direction matrix (VTK and ParaView since 9.0); a sheared one cannot be an image.
/// Missing samples are NaN, and hidden by a "vtkGhostType" array if there are any. Field data hold
/// "CRS_WKT", "GeoTransform" and the notes. 1 x N rasters and rasters without any valid sample are
/// written as they are.
/// \throws InvalidField see check_samples; also when shear would misplace a sample by more than a
/// thousandth of the spacing.
/// \throws WriteError
void write_image(const Surface& surface, const std::filesystem::path& path,
                 const WriteOptions& options = {});

}  // namespace arete::vtk
