// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "arete/vtk/internal/stage.h"

class vtkCamera;

namespace arete::vtk {

/// Perspective from the south, `pitch` degrees above the horizon, as near as keeps all the points
/// within `fill` (below 1) of a picture of this aspect (width / height).
void look_from_south(std::span<const Vector3> points, double pitch, double aspect, double fill,
                     vtkCamera& camera);

/// Straight down, north up, no perspective.
void look_down(std::span<const Vector3> points, double aspect, double fill, vtkCamera& camera);

/// How far right of the picture's middle the points reach at most: 1 is the edge.
[[nodiscard]] double reach_right(std::span<const Vector3> points, double aspect, vtkCamera& camera);

}  // namespace arete::vtk
