// SPDX-License-Identifier: MIT
#pragma once

#include "arete/vtk/image.h"

namespace arete::vtk {

/// A light so far away that its rays are parallel, standing fast while the camera moves.
struct Light {
  double azimuth = 315;   ///< degrees clockwise from north
  double elevation = 40;  ///< degrees above the horizon, 0 to 90
  double intensity = 1;   ///< 0 to 10; several lights add up
  Rgb color{255, 250, 240};
};

/// How much of the light the ground gives back: shares from 0 to 1 of Phong's model.
struct Material {
  double ambient = 0.36;       ///< of a light without direction
  double diffuse = 0.86;       ///< by the cosine to the light
  double specular = 0.04;      ///< highlights, none in a map
  double specular_power = 15;  ///< 1 to 128: the larger, the smaller the highlights
};

/// \throws RenderError naming the value that is out of range.
void check(const Light& light);
void check(const Material& material);

}  // namespace arete::vtk
