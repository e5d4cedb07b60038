// SPDX-License-Identifier: MIT
#include "internal/structured_refine.h"

#include <sstream>

#include "internal/cell_data.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

namespace arete::vtk_filters {
namespace {

std::string text(const VtkExtent& e) {
  std::ostringstream out;
  out << e[0] << ".." << e[1] << " x " << e[2] << ".." << e[3] << " x " << e[4] << ".." << e[5];
  return out.str();
}

}  // namespace

StructuredPlan plan_refinement(const Settings& settings, int levels, Alignment alignment,
                               bool limit, const VtkExtent& whole_input) {
  const auto axis = [&](const Scheme& scheme, int along, Boundary boundary) {
    AxisOptions options{levels, boundary, alignment, {}, FinalResult::samples};
    if (limit) options.final_stencil = required_limit_of(scheme);
    return AxisPlan(scheme.mask(), count_along(whole_input, along), options);
  };
  return {axis(settings.x, 0, settings.boundaries.x), axis(settings.y, 1, settings.boundaries.y),
          whole_input};
}

void announce(vtkInformation* out, const VtkExtent& whole) {
  VtkExtent extent = whole;
  out->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent.data(), 6);
  out->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
}

VtkExtent update_extent(vtkInformation* out) {
  VtkExtent extent{0, -1, 0, -1, 0, -1};
  vtkStreamingDemandDrivenPipeline::GetUpdateExtent(out, extent.data());
  return extent;
}

void check_input(const VtkExtent& held, const StructuredPiece& piece) {
  const VtkExtent needed = piece.needed();
  if (contains(held, needed)) return;
  throw InvalidField("the input holds the points " + text(held) + ", but the output " +
                     text(piece.part()) + " needs " + text(needed) +
                     "; give the filter a source that can be asked for extents, or data with that "
                     "halo");
}

double attribute_steps(vtkDataSet* input, const PointRefiner& refiner) {
  double steps = input->GetPointGhostArray() ? refiner.steps(nullptr) : 0;
  for (vtkDataArray* array : refinable_arrays(input->GetPointData())) steps += refiner.steps(array);
  return steps;
}

bool refine_attributes(vtkDataSet* input, vtkDataSet* output, const StructuredPiece& piece,
                       const HeldInput& held, const PointRefiner& refiner, PointRule rule, int type,
                       Work& work) {
  vtkPointData* from = input->GetPointData();
  for (vtkDataArray* array : refinable_arrays(from)) {
    const auto result = refined_like(array, refiner.points(),
                                     type == 0 ? refined_type(array->GetDataType()) : type);
    if (!refiner.refine(array, result, rule, work)) return false;
    add_like(from, array, output->GetPointData(), result);
  }
  if (held.ghosts) {
    const vtkNew<vtkUnsignedCharArray> flags;
    flags->SetName(vtkDataSetAttributes::GhostArrayName());
    flags->SetNumberOfTuples(refiner.points());
    if (!refiner.mark_hidden(flags, work)) return false;
    output->GetPointData()->AddArray(flags);
  }
  copy_parent_cell_data(input->GetCellData(), held.extent, output->GetCellData(), piece);
  return true;
}

}  // namespace arete::vtk_filters
