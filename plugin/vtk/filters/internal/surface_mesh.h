// SPDX-License-Identifier: MIT
#pragma once

#include "internal/surface_planes.h"

class vtkDataArray;
class vtkImageData;
class vtkPolyData;

namespace arete::vtk_filters {

/// Where and how a part of a height image becomes polygons.
struct SurfaceForm {
  vtkImageData& image;    ///< frame, and data to pass on
  vtkDataArray* heights;  ///< not passed on as it is
  VtkExtent whole;
  VtkExtent part;
  /// Where result 0 lies among the samples of the whole.
  double first_x = 0;
  double first_y = 0;
  double factor = 1;   ///< of the heights
  bool blank = false;  ///< keep and hide what is missing
};

/// Points, quads counter-clockwise seen from above, Normals, Slope, TextureCoordinates, and the
/// data passed on.
void make_surface(const SurfaceForm& form, const SurfacePlanes& planes, vtkPolyData* output);

}  // namespace arete::vtk_filters
