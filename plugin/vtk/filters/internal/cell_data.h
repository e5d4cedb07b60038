// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "arete/refine/axis_places.h"
#include "internal/structured_piece.h"

class vtkCellData;

namespace arete::vtk_filters {

/// The old cell along one axis that each new cell between `points` lies in: one entry a new cell,
/// at least one (an axis of one point has one cell in VTK). Old cells are 0..count-2 (count-1 on an
/// axis that `wraps`, where VTK has a cell between the last sample and the first).
[[nodiscard]] std::vector<Index> parent_cells(const AxisPlan& plan, IndexRange points, bool wraps);

/// Gives every cell of the piece the data of its parent. Ghost flags other than "hidden" are
/// dropped.
void copy_parent_cell_data(vtkCellData* from, const VtkExtent& from_extent, vtkCellData* to,
                           const StructuredPiece& piece);

/// Clears all flags of a vtkGhostType array of cells but "hidden".
void keep_hidden_cells_only(vtkCellData* data);

}  // namespace arete::vtk_filters
