// SPDX-License-Identifier: MIT
#pragma once

#include "arete/vtk/internal/local_plane.h"
#include "arete/vtk/light.h"

namespace arete::vtk {

/// How much of a light each sample sees over the terrain between, 0 to 1, as if the light were a
/// disc of two degrees, so that shadows grow softer with their length. Light passes over missing
/// samples and comes in freely from beyond the raster.
///
/// One sweep over the raster away from the light, along parallel rays a sample apart: each carries
/// the upper edge of the shadow that the terrain it passed throws. O(samples).
///
/// VTK's own shadow maps (vtkShadowMapPass) are of no use here: in VTK 9.1 their frustum for lights
/// without a position cuts off half a terrain, and their exponential falloff leaks.
[[nodiscard]] Grid<float> sun_view(const Surface& surface, const LocalPlane& plane,
                                   double exaggeration, const Light& light);

}  // namespace arete::vtk
