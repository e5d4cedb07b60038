// SPDX-License-Identifier: MIT
#include "internal/cell_data.h"

#include "vtkCellData.h"
#include "vtkUnsignedCharArray.h"

namespace arete::vtk_filters {

std::vector<Index> parent_cells(const AxisPlan& plan, IndexRange points, bool wraps) {
  const Index cells = std::max(points.count() - 1, Index{1});
  const std::vector<AxisPlace> places =
      points.count() > 1 ? middle_places(plan, {points.first, points.first + cells - 1})
                         : sample_places(plan, points);
  const Index last = std::max(plan.input_count() - (wraps ? 1 : 2), Index{0});
  std::vector<Index> parents;
  parents.reserve(places.size());
  for (const AxisPlace& place : places) parents.push_back(std::min(place.cell, last));
  return parents;
}

void copy_parent_cell_data(vtkCellData* from, const VtkExtent& from_extent, vtkCellData* to,
                           const StructuredPiece& piece) {
  if (from->GetNumberOfArrays() == 0) return;
  const StructuredPlan& plan = piece.plan();
  const std::vector<Index> rows = parent_cells(plan.y, piece.rows(), false);
  const std::vector<Index> cols = parent_cells(plan.x, piece.cols(), false);
  const auto cells_along = [](const VtkExtent& e, int axis) {
    return std::max(count_along(e, axis) - 1, Index{1});
  };
  const Index slices = cells_along(piece.part(), 2);
  const Index width = cells_along(from_extent, 0);
  const Index height = cells_along(from_extent, 1);
  const Index first_col = from_extent[0] - plan.input[0];
  const Index first_row = from_extent[2] - plan.input[2];
  const Index first_slice = piece.part()[4] - from_extent[4];
  to->CopyGlobalIdsOff();
  to->CopyAllocate(from, slices * static_cast<Index>(rows.size() * cols.size()));
  vtkIdType cell = 0;
  for (Index k = 0; k < slices; ++k)
    for (const Index row : rows)
      for (const Index col : cols)
        to->CopyData(from, ((first_slice + k) * height + row - first_row) * width + col - first_col,
                     cell++);
  keep_hidden_cells_only(to);
}

void keep_hidden_cells_only(vtkCellData* data) {
  auto* flags =
      vtkUnsignedCharArray::SafeDownCast(data->GetArray(vtkDataSetAttributes::GhostArrayName()));
  if (!flags) return;
  for (vtkIdType i = 0; i < flags->GetNumberOfTuples(); ++i)
    flags->SetValue(i, flags->GetValue(i) & vtkDataSetAttributes::HIDDENCELL);
}

}  // namespace arete::vtk_filters
