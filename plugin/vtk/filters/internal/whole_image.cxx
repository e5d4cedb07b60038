// SPDX-License-Identifier: MIT
#include "internal/whole_image.h"

#include <limits>

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

namespace arete::vtk_filters {

Grid<double> whole_plane(vtkImageData* image, vtkDataArray* array, int component) {
  const int* size = image->GetDimensions();
  Grid<double> plane({size[1], size[0]});
  vtkUnsignedCharArray* ghosts = image->GetPointGhostArray();
  for (std::size_t i = 0; i < plane.samples().size(); ++i) {
    const auto point = static_cast<vtkIdType>(i);
    const bool hidden =
        ghosts && (ghosts->GetValue(point) & vtkDataSetAttributes::HIDDENPOINT) != 0;
    plane.samples()[i] =
        hidden ? std::numeric_limits<double>::quiet_NaN() : array->GetComponent(point, component);
  }
  return plane;
}

void put_plane(const Grid<double>& plane, const ValidSamples& valid, vtkDataArray* array,
               int component) {
  for (std::size_t i = 0; i < plane.samples().size(); ++i)
    array->SetComponent(static_cast<vtkIdType>(i), component,
                        valid.empty() || valid[i] != 0 ? plane.samples()[i]
                                                       : std::numeric_limits<double>::quiet_NaN());
}

void hide_points(const ValidSamples& valid, vtkImageData* image) {
  const vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(image->GetNumberOfPoints());
  ghosts->Fill(0);
  for (std::size_t i = 0; i < valid.size(); ++i)
    if (valid[i] == 0)
      ghosts->SetValue(static_cast<vtkIdType>(i), vtkDataSetAttributes::HIDDENPOINT);
  image->GetPointData()->AddArray(ghosts);
}

}  // namespace arete::vtk_filters
