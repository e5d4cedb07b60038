// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "arete/vtk/internal/stage.h"

class vtkActor;

namespace arete::vtk {

/// Gives the actor upright walls from the outer edge of the terrain down to the height `foot`, so
/// that it stands there as a block and not as a sheet. Holes within the terrain get no walls: one
/// looks through them.
/// \returns the walls' points.
std::vector<Vector3> set_block_walls(const Stage& stage, double foot, vtkActor& actor);

}  // namespace arete::vtk
