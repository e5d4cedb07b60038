// SPDX-License-Identifier: MIT
#include "internal/image_place.h"

#include "internal/structured_refine.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"

namespace arete::vtk_filters {

void announce_image(vtkInformation* in, vtkInformation* out, const VtkExtent& extent,
                    const StepsAlong& x, const StepsAlong& y) {
  double spacing[3]{1, 1, 1};
  double origin[3]{0, 0, 0};
  double direction[9]{1, 0, 0, 0, 1, 0, 0, 0, 1};
  if (in->Has(vtkDataObject::SPACING())) in->Get(vtkDataObject::SPACING(), spacing);
  if (in->Has(vtkDataObject::ORIGIN())) in->Get(vtkDataObject::ORIGIN(), origin);
  if (in->Has(vtkDataObject::DIRECTION())) in->Get(vtkDataObject::DIRECTION(), direction);
  const double first[2]{x.first * spacing[0], y.first * spacing[1]};
  for (int row = 0; row < 3; ++row)
    origin[row] += direction[3 * row] * first[0] + direction[3 * row + 1] * first[1];
  spacing[0] *= x.spacing;
  spacing[1] *= y.spacing;
  announce(out, extent);
  out->Set(vtkDataObject::SPACING(), spacing, 3);
  out->Set(vtkDataObject::ORIGIN(), origin, 3);
  out->Set(vtkDataObject::DIRECTION(), direction, 9);
}

void lay_out(vtkInformation* out, const VtkExtent& extent, vtkImageData* image) {
  image->SetExtent(const_cast<int*>(extent.data()));
  image->SetOrigin(out->Get(vtkDataObject::ORIGIN()));
  image->SetSpacing(out->Get(vtkDataObject::SPACING()));
  image->SetDirectionMatrix(out->Get(vtkDataObject::DIRECTION()));
}

}  // namespace arete::vtk_filters
