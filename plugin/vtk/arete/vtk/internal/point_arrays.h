// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "arete/vtk/internal/local_plane.h"
#include "arete/vtk/internal/sample_order.h"

class vtkDataSet;
class vtkPointSet;

namespace arete::vtk {

/// Which sample a point of the file is.
using SampleOf = std::function<Sample(Index point)>;

/// Adds the active scalars "height", of the type of the surface's heights; and, if any of them is
/// missing, "vtkGhostType" with HIDDENPOINT there, which VTK's filters and ParaView leave out.
void add_heights(const Surface& surface, Index count, const SampleOf& sample_of, vtkDataSet& out);

/// Sets points (double; a missing sample lies at the lowest height there is, so that bounds stay
/// finite), and adds "height", "slope" (float, degrees from level, NaN at missing samples) and the
/// active normals "Normals" (float, unit, upward).
void add_surface_points(const Surface& surface, const LocalPlane& plane, Index count,
                        const SampleOf& sample_of, vtkPointSet& out);

}  // namespace arete::vtk
