// SPDX-License-Identifier: MIT
#include "vtkAreteRefineImage.h"

#include "internal/guarded.h"
#include "internal/image_place.h"
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

StepsAlong steps_along(const arete::AxisPlan& axis) {
  return {arete::to_double(axis.first_position()), arete::to_double(axis.spacing())};
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
    announce_image(in, out, plan.output, steps_along(plan.x), steps_along(plan.y));
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
    const HeldInput held = held_for(piece, input);
    const PointRefiner refiner(piece, held, this->NumberOfThreads);

    lay_out(out, wanted, output);
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
