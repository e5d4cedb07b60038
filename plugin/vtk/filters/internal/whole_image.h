// SPDX-License-Identifier: MIT
#pragma once

#include "arete/reverse/missing_samples.h"

class vtkDataArray;
class vtkImageData;

namespace arete::vtk_filters {

/// One component of a point array of a flat image, row by row (j by j); NaN at hidden points.
[[nodiscard]] Grid<double> whole_plane(vtkImageData* image, vtkDataArray* array, int component);

/// Puts a plane into a component; samples that are not `valid` (empty: all are) become NaN.
void put_plane(const Grid<double>& plane, const ValidSamples& valid, vtkDataArray* array,
               int component);

/// Hides the points of the image that are not valid.
void hide_points(const ValidSamples& valid, vtkImageData* image);

}  // namespace arete::vtk_filters
