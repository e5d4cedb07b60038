// SPDX-License-Identifier: MIT
#pragma once

#include "arete/vtk/internal/local_plane.h"

namespace arete::vtk {

/// A vertical exaggeration with which relief reads well, to two significant digits: one that makes
/// the root mean square of the gradient 0.45, or the relief 0.16 of the plan's diagonal if that is
/// less. Below 1 for heights in smaller units than the plane; 1 for a level surface.
[[nodiscard]] double choose_exaggeration(const Surface& surface, const LocalPlane& plane);

}  // namespace arete::vtk
