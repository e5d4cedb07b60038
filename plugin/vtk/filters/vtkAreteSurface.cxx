// SPDX-License-Identifier: MIT
#include "vtkAreteSurface.h"

#include "internal/guarded.h"
#include "internal/structured_refine.h"
#include "internal/structured_request.h"
#include "internal/surface_mesh.h"
#include "internal/surface_planes.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

using namespace arete::vtk_filters;

vtkStandardNewMacro(vtkAreteSurface);

vtkAreteSurface::vtkAreteSurface() {
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS,
                               vtkDataSetAttributes::SCALARS);
}
vtkAreteSurface::~vtkAreteSurface() = default;

int vtkAreteSurface::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkAreteSurface::FillOutputPortInformation(int, vtkInformation* info) {
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPolyData");
  return 1;
}

int vtkAreteSurface::RequestDataObject(vtkInformation*, vtkInformationVector**,
                                       vtkInformationVector* outputs) {
  vtkInformation* out = outputs->GetInformationObject(0);
  if (!vtkPolyData::GetData(out)) {
    const vtkNew<vtkPolyData> output;
    out->Set(vtkDataObject::DATA_OBJECT(), output);
  }
  return 1;
}

int vtkAreteSurface::RequestInformation(vtkInformation*, vtkInformationVector**,
                                        vtkInformationVector* outputs) {
  outputs->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

int vtkAreteSurface::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs,
                                         vtkInformationVector* outputs) {
  return guarded(this, [&] {
    vtkInformation* in = inputs[0]->GetInformationObject(0);
    const VtkExtent whole = whole_extent(in);
    const VtkExtent part = requested_part(outputs->GetInformationObject(0), whole);
    request_extent(
        in, is_empty(part)
                ? part
                : SurfacePlans(settings_of(this), this->Limit != 0, whole).needed(whole, part));
    return 1;
  });
}

int vtkAreteSurface::RequestData(vtkInformation*, vtkInformationVector** inputs,
                                 vtkInformationVector* outputs) {
  return guarded(this, vtkDataObject::GetData(outputs), [&] {
    vtkInformation* in = inputs[0]->GetInformationObject(0);
    vtkInformation* out = outputs->GetInformationObject(0);
    vtkImageData* input = vtkImageData::GetData(in);
    vtkPolyData* output = vtkPolyData::GetData(out);
    const VtkExtent whole = whole_extent(in);
    const VtkExtent part = requested_part(out, whole);
    if (is_empty(part) || input->GetNumberOfPoints() == 0) return 1;
    if (whole[4] != whole[5])
      throw arete::InvalidField("a surface is made of a flat image, this one has " +
                                std::to_string(count_along(whole, 2)) +
                                " slices along k; extract one (vtkExtractVOI)");
    vtkDataArray* heights = this->GetInputArrayToProcess(0, inputs);
    if (!heights || heights->GetNumberOfTuples() != input->GetNumberOfPoints())
      throw arete::InvalidField(
          "the image has no point array of heights; choose one (SetInputArrayToProcess)");
    if (heights->GetNumberOfComponents() != 1)
      throw arete::InvalidField("the heights have " +
                                std::to_string(heights->GetNumberOfComponents()) +
                                " components; choose an array with one");

    const SurfacePlans plans(settings_of(this), this->Limit != 0, whole);
    HeldInput held;
    input->GetExtent(held.extent.data());
    held.ghosts = input->GetPointGhostArray();
    if (!contains(held.extent, plans.needed(whole, part)))
      throw arete::InvalidField(
          "the input does not hold the halo that its part of the surface "
          "needs; give the filter a source that can be asked for extents");
    Work work(this, 3.0 * static_cast<double>(count_along(part, 1)));
    const auto planes =
        surface_planes(plans, whole, part, heights, held, this->NumberOfThreads, work);
    if (!planes) return 1;
    SurfaceForm form{*input, heights, whole, part};
    form.first_x = arete::to_double(plans.x.height.first_position());
    form.first_y = arete::to_double(plans.y.height.first_position());
    form.factor = this->ScaleFactor;
    form.blank = this->Missing == BLANK;
    make_surface(form, *planes, output);

    output->GetFieldData()->ShallowCopy(input->GetFieldData());
    const vtkNew<vtkStringArray> origin;
    origin->SetName("AreteNormals");
    origin->InsertNextValue(plans.limit_normals ? "limit surface" : "central differences");
    output->GetFieldData()->AddArray(origin);
    return 1;
  });
}

void vtkAreteSurface::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Missing: " << (this->Missing == BLANK ? "blank" : "drop") << "\n";
  os << indent << "Limit: " << (this->Limit ? "on" : "off") << "\n";
  os << indent << "ScaleFactor: " << this->ScaleFactor << "\n";
}
