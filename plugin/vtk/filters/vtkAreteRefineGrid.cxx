// SPDX-License-Identifier: MIT
#include "vtkAreteRefineGrid.h"

#include <cmath>

#include "internal/guarded.h"
#include "internal/refine_polygons.h"
#include "internal/structured_refine.h"
#include "internal/structured_request.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"

using namespace arete::vtk_filters;

vtkStandardNewMacro(vtkAreteRefineGrid);

vtkAreteRefineGrid::vtkAreteRefineGrid() = default;
vtkAreteRefineGrid::~vtkAreteRefineGrid() = default;

int vtkAreteRefineGrid::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkStructuredGrid");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

namespace {

bool is_structured(vtkInformation* info) { return vtkStructuredGrid::GetData(info) != nullptr; }

StructuredPlan plan_of(vtkAreteRefineGrid* filter, const VtkExtent& whole) {
  return plan_refinement(settings_of(filter), filter->GetLevels(), arete::Alignment::nodes,
                         filter->GetLimit() != 0, whole);
}

PointRule rule_of(vtkAreteRefineGrid* filter) {
  return filter->GetPointData() == vtkAreteRefineGrid::LINEAR ? PointRule::linear
                                                              : PointRule::scheme;
}

// Where hidden points left no coordinates, those between the input's own.
bool refine_points(vtkDataArray* from, vtkDataArray* to, const StructuredPiece& piece,
                   const HeldInput& held, const PointRefiner& refiner, int threads, Work& work) {
  if (!refiner.refine(from, to, PointRule::scheme, work)) return false;
  if (!held.ghosts) return true;
  const PointRefiner all(piece, {held.extent, nullptr}, threads);
  const auto between = refined_like(from, to->GetNumberOfTuples(), to->GetDataType());
  if (!all.refine(from, between, PointRule::linear, work)) return false;
  for (vtkIdType i = 0; i < to->GetNumberOfTuples(); ++i)
    for (int c = 0; c < 3; ++c)
      if (!std::isfinite(to->GetComponent(i, c)))
        to->SetComponent(i, c, between->GetComponent(i, c));
  return true;
}

}  // namespace

int vtkAreteRefineGrid::RequestInformation(vtkInformation*, vtkInformationVector** inputs,
                                           vtkInformationVector* outputs) {
  return guarded(this, [&] {
    vtkInformation* in = inputs[0]->GetInformationObject(0);
    vtkInformation* out = outputs->GetInformationObject(0);
    if (!is_structured(in)) {
      // A request for pieces comes through; all but the first are empty.
      out->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
      return 1;
    }
    const VtkExtent whole = whole_extent(in);
    announce(out, is_empty(whole) ? whole : plan_of(this, whole).output);
    return 1;
  });
}

int vtkAreteRefineGrid::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs,
                                            vtkInformationVector* outputs) {
  return guarded(this, [&] {
    vtkInformation* in = inputs[0]->GetInformationObject(0);
    vtkInformation* out = outputs->GetInformationObject(0);
    if (!is_structured(in)) {
      in->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), 0);
      in->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), 1);
      in->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
      return 1;
    }
    const VtkExtent wanted = requested_extent(out, whole_extent(out));
    request_extent(in, is_empty(wanted)
                           ? wanted
                           : StructuredPiece(plan_of(this, whole_extent(in)), wanted).needed());
    return 1;
  });
}

int vtkAreteRefineGrid::RequestData(vtkInformation*, vtkInformationVector** inputs,
                                    vtkInformationVector* outputs) {
  return guarded(this, vtkDataObject::GetData(outputs), [&] {
    vtkInformation* in = inputs[0]->GetInformationObject(0);
    vtkInformation* out = outputs->GetInformationObject(0);
    return is_structured(in) ? this->RefineStructured(in, out) : this->RefinePolygons(in, out);
  });
}

int vtkAreteRefineGrid::RefineStructured(vtkInformation* in, vtkInformation* out) {
  vtkStructuredGrid* input = vtkStructuredGrid::GetData(in);
  vtkStructuredGrid* output = vtkStructuredGrid::GetData(out);
  const VtkExtent wanted = update_extent(out);
  if (is_empty(wanted) || input->GetNumberOfPoints() == 0 || !input->GetPoints()) return 1;

  const StructuredPiece piece(plan_of(this, whole_extent(in)), wanted);
  const HeldInput held = held_for(piece, input);
  const PointRefiner refiner(piece, held, this->NumberOfThreads);

  vtkDataArray* coordinates = input->GetPoints()->GetData();
  Work work(this,
            attribute_steps(input, refiner) + (held.ghosts ? 2 : 1) * refiner.steps(coordinates));
  const auto refined =
      refined_like(coordinates, refiner.points(), refined_type(coordinates->GetDataType()));
  output->SetExtent(const_cast<int*>(wanted.data()));
  vtkNew<vtkPoints> points;
  points->SetDataType(refined->GetDataType());
  bool finished =
      refine_points(coordinates, refined, piece, held, refiner, this->NumberOfThreads, work);
  if (finished) {
    points->SetData(refined);
    output->SetPoints(points);
    output->GetFieldData()->ShallowCopy(input->GetFieldData());
    finished = refine_attributes(input, output, piece, held, refiner, rule_of(this), 0, work);
  }
  if (!finished) output->Initialize();
  return 1;
}

int vtkAreteRefineGrid::RefinePolygons(vtkInformation* in, vtkInformation* out) {
  vtkPolyData* input = vtkPolyData::GetData(in);
  vtkPolyData* output = vtkPolyData::GetData(out);
  if (vtkStreamingDemandDrivenPipeline::GetUpdatePiece(out) > 0) return 1;
  output->GetFieldData()->ShallowCopy(input->GetFieldData());
  if (input->GetNumberOfPoints() == 0 || input->GetNumberOfCells() == 0) return 1;
  if (!refine_polygons(input, output, settings_of(this), this->Levels, this->Limit != 0,
                       rule_of(this), this))
    output->Initialize();
  return 1;
}

void vtkAreteRefineGrid::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Levels: " << this->Levels << "\n";
  os << indent << "PointData: " << (this->PointData == LINEAR ? "linear" : "scheme") << "\n";
  os << indent << "Limit: " << (this->Limit ? "on" : "off") << "\n";
}
