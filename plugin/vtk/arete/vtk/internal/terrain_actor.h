// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "arete/vtk/colormap.h"
#include "arete/vtk/internal/stage.h"

class vtkActor;

namespace arete::vtk {

/// How heights become colours.
struct HeightColors {
  const Colormap* colors = nullptr;  ///< none: white, for a texture
  double low = 0;
  double high = 1;

  [[nodiscard]] Rgb operator()(double height) const;
};

/// Gives the actor the mesh of a surface, with smooth normals and a colour at every point.
/// \returns the points. \throws InvalidField when not a single quad is whole.
std::vector<Vector3> set_terrain(const Stage& stage, const HeightColors& colors, vtkActor& actor);

}  // namespace arete::vtk
