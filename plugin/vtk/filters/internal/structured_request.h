// SPDX-License-Identifier: MIT
#pragma once

#include "internal/structured_piece.h"

class vtkInformation;

namespace arete::vtk_filters {

/// The whole extent that an output or input announces.
[[nodiscard]] VtkExtent whole_extent(vtkInformation* info);

/// The extent that a structured output will be asked to fill. The executive splits a request by
/// pieces only after REQUEST_UPDATE_EXTENT, so the same split is made here; a filter that looked at
/// UPDATE_EXTENT alone would ask for the halo of the whole. Empty for a piece without cells.
[[nodiscard]] VtkExtent requested_extent(vtkInformation* out, const VtkExtent& whole);

/// The same for an output without extents (polygons) that is made of the cells of a structured
/// whole: the split is the one of VTK's readers and sources.
[[nodiscard]] VtkExtent requested_part(vtkInformation* out, const VtkExtent& whole);

/// Asks upstream for exactly these points, as one piece.
void request_extent(vtkInformation* in, const VtkExtent& extent);

}  // namespace arete::vtk_filters
