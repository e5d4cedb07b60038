// SPDX-License-Identifier: MIT
#pragma once

#include "internal/structured_piece.h"

class vtkImageData;
class vtkInformation;

namespace arete::vtk_filters {

/// Where the samples of a result lie along one axis of the input: the first one, in steps of the
/// input's spacing from its origin, and how many such steps apart they are.
struct StepsAlong {
  double first = 0;
  double spacing = 1;
};

/// Announces a result of extent `extent`, whose index 0 lies as x and y say among the input's
/// samples: index i of the input lies at origin + D (i spacing), that of the result likewise.
void announce_image(vtkInformation* in, vtkInformation* out, const VtkExtent& extent,
                    const StepsAlong& x, const StepsAlong& y);

/// Lays the result's image out where it was announced.
void lay_out(vtkInformation* out, const VtkExtent& extent, vtkImageData* image);

}  // namespace arete::vtk_filters
