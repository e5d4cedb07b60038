// SPDX-License-Identifier: MIT
#pragma once

#include "internal/point_data.h"
#include "internal/settings.h"

class vtkAlgorithm;
class vtkPolyData;

namespace arete::vtk_filters {

/// Refines every grid that the polygons are made of.
///
/// The points of an axis that wraps are refined with boundary periodic whatever the settings say.
/// Points without polygons are dropped. False if aborted.
/// \throws NotAGrid naming point or cell; InvalidField for verts, lines or strips, for coordinates
/// that are not finite, more points than an int counts, an axis that is left with too few points,
/// and boundary periodic on an open axis, which would bend its rim to the other side.
bool refine_polygons(vtkPolyData* input, vtkPolyData* output, const Settings& settings, int levels,
                     bool limit, PointRule rule, vtkAlgorithm* filter);

}  // namespace arete::vtk_filters
