// SPDX-License-Identifier: MIT
#pragma once

#include "arete/vtk/internal/local_plane.h"

namespace arete::vtk {

/// How much of the sky each sample sees, 0 to 1: what makes valleys a little darker than ridges,
/// wherever the light stands. Horizons in eight directions, out to 32 samples.
[[nodiscard]] Grid<float> sky_view(const Surface& surface, const LocalPlane& plane,
                                   double exaggeration);

}  // namespace arete::vtk
