// SPDX-License-Identifier: MIT
#include "vtkAreteRefineImage.h"

#include "internal/guarded.h"
#include "internal/structured_refine.h"
#include "internal/structured_request.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

using namespace arete::vtk_filters;

vtkStandardNewMacro(vtkAreteRefineImage);

vtkAreteRefineImage::vtkAreteRefineImage() = default;
vtkAreteRefineImage::~vtkAreteRefineImage() = default;

void vtkAreteRefineImage::SetOutputScalarType(int type) {
  if (type != 0 && type != VTK_FLOAT && type != VTK_DOUBLE) {
    vtkErrorMacro(<< "OutputScalarType " << type << " is none of 0, VTK_FLOAT, VTK_DOUBLE");
    return;
  }
  if (this->OutputScalarType == type) return;
  this->OutputScalarType = type;
  this->Modified();
}

vtkImageData* vtkAreteRefineImage::GetOutput() { return this->GetOutput(0); }

vtkImageData* vtkAreteRefineImage::GetOutput(int port) {
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(port));
}

int vtkAreteRefineImage::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkAreteRefineImage::FillOutputPortInformation(int, vtkInformation* info) {
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkImageData");
  return 1;
}

namespace {

StructuredPlan plan_of(vtkAreteRefineImage* filter, const VtkExtent& whole) {
  return plan_refinement(settings_of(filter), filter->GetLevels(),
                         static_cast<arete::Alignment>(filter->GetAlignment()),
                         filter->GetLimit() != 0, whole);
}

// Input index i lies at origin + D (i spacing); result index i at the new origin likewise.
void announce_place(vtkInformation* in, vtkInformation* out, const StructuredPlan& plan) {
  double spacing[3]{1, 1, 1};
  double origin[3]{0, 0, 0};
  double direction[9]{1, 0, 0, 0, 1, 0, 0, 0, 1};
  if (in->Has(vtkDataObject::SPACING())) in->Get(vtkDataObject::SPACING(), spacing);
  if (in->Has(vtkDataObject::ORIGIN())) in->Get(vtkDataObject::ORIGIN(), origin);
  if (in->Has(vtkDataObject::DIRECTION())) in->Get(vtkDataObject::DIRECTION(), direction);
  const double first[2]{arete::to_double(plan.x.first_position()) * spacing[0],
                        arete::to_double(plan.y.first_position()) * spacing[1]};
  for (int row = 0; row < 3; ++row)
    origin[row] += direction[3 * row] * first[0] + direction[3 * row + 1] * first[1];
  spacing[0] *= arete::to_double(plan.x.spacing());
  spacing[1] *= arete::to_double(plan.y.spacing());
  out->Set(vtkDataObject::SPACING(), spacing, 3);
  out->Set(vtkDataObject::ORIGIN(), origin, 3);
  out->Set(vtkDataObject::DIRECTION(), direction, 9);
}

}  // namespace

int vtkAreteRefineImage::RequestInformation(vtkInformation*, vtkInformationVector** inputs,
                                            vtkInformationVector* outputs) {
  return guarded(this, [&] {
    vtkInformation* in = inputs[0]->GetInformationObject(0);
    vtkInformation* out = outputs->GetInformationObject(0);
    const VtkExtent whole = whole_extent(in);
    if (is_empty(whole)) {
      announce(out, whole);
      return 1;
    }
    const StructuredPlan plan = plan_of(this, whole);
    announce(out, plan.output);
    announce_place(in, out, plan);
    if (vtkInformation* scalars = vtkDataObject::GetActiveFieldInformation(
            in, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS)) {
      int type = this->OutputScalarType;
      if (type == 0 && scalars->Has(vtkDataObject::FIELD_ARRAY_TYPE()))
        type = refined_type(scalars->Get(vtkDataObject::FIELD_ARRAY_TYPE()));
      const int components = scalars->Has(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS())
                                 ? scalars->Get(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS())
                                 : 1;
      if (type != 0) vtkDataObject::SetPointDataActiveScalarInfo(out, type, components);
    }
    return 1;
  });
}

int vtkAreteRefineImage::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs,
                                             vtkInformationVector* outputs) {
  return guarded(this, [&] {
    vtkInformation* in = inputs[0]->GetInformationObject(0);
    vtkInformation* out = outputs->GetInformationObject(0);
    const VtkExtent wanted = requested_extent(out, whole_extent(out));
    if (is_empty(wanted))
      request_extent(in, wanted);
    else
      request_extent(in, StructuredPiece(plan_of(this, whole_extent(in)), wanted).needed());
    return 1;
  });
}

int vtkAreteRefineImage::RequestData(vtkInformation*, vtkInformationVector** inputs,
                                     vtkInformationVector* outputs) {
  return guarded(this, vtkDataObject::GetData(outputs), [&] {
    vtkInformation* in = inputs[0]->GetInformationObject(0);
    vtkInformation* out = outputs->GetInformationObject(0);
    vtkImageData* input = vtkImageData::GetData(in);
    vtkImageData* output = vtkImageData::GetData(out);
    const VtkExtent wanted = update_extent(out);
    if (is_empty(wanted) || input->GetNumberOfPoints() == 0) return 1;

    const StructuredPiece piece(plan_of(this, whole_extent(in)), wanted);
    HeldInput held;
    input->GetExtent(held.extent.data());
    held.ghosts = input->GetPointGhostArray();
    check_input(held.extent, piece);
    const PointRefiner refiner(piece, held, this->NumberOfThreads);

    output->SetExtent(const_cast<int*>(wanted.data()));
    output->SetOrigin(out->Get(vtkDataObject::ORIGIN()));
    output->SetSpacing(out->Get(vtkDataObject::SPACING()));
    output->SetDirectionMatrix(out->Get(vtkDataObject::DIRECTION()));
    output->GetFieldData()->ShallowCopy(input->GetFieldData());
    Work work(this, attribute_steps(input, refiner));
    if (!refine_attributes(input, output, piece, held, refiner, PointRule::scheme,
                           this->OutputScalarType, work))
      output->Initialize();
    return 1;
  });
}

void vtkAreteRefineImage::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Levels: " << this->Levels << "\n";
  os << indent << "Alignment: " << (this->Alignment == CELLS ? "cells" : "nodes") << "\n";
  os << indent << "Limit: " << (this->Limit ? "on" : "off") << "\n";
  os << indent << "OutputScalarType: " << this->OutputScalarType << "\n";
}
