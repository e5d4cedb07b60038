// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "arete/vtk/internal/stage.h"

class vtkCamera;

namespace arete::vtk {

/// Where a camera stands: degrees clockwise from north, and degrees above the horizon (below 90).
struct Viewpoint {
  double azimuth = 180;
  double pitch = 42;
};

/// Perspective, as near as keeps all the points within `fill` (below 1) of a picture of this aspect
/// (width / height).
void look_from(std::span<const Vector3> points, const Viewpoint& from, double aspect, double fill,
               vtkCamera& camera);

/// How far a camera has to stand from `middle` for that, looking at it, from every azimuth given.
[[nodiscard]] double orbit_radius(std::span<const Vector3> points, const Vector3& middle,
                                  double pitch, std::span<const double> azimuths, double aspect,
                                  double fill);

/// Perspective towards `middle` from that far: a camera that walks round without the picture
/// jumping.
void look_at(std::span<const Vector3> points, const Vector3& middle, const Viewpoint& from,
             double radius, vtkCamera& camera);

/// Straight down, north up, no perspective.
void look_down(std::span<const Vector3> points, double aspect, double fill, vtkCamera& camera);

/// How far right of the picture's middle the points reach at most: 1 is the edge.
[[nodiscard]] double reach_right(std::span<const Vector3> points, double aspect, vtkCamera& camera);

}  // namespace arete::vtk
