// SPDX-License-Identifier: MIT
#pragma once

#include "internal/point_data.h"
#include "internal/settings.h"

class vtkDataSet;
class vtkInformation;

namespace arete::vtk_filters {

/// What the two filters of structured data have in common.

/// \throws InvalidField, InvalidScheme
[[nodiscard]] StructuredPlan plan_refinement(const Settings& settings, int levels,
                                             Alignment alignment, bool limit,
                                             const VtkExtent& whole_input);

/// Announces the whole extent, and that any part of it can be made.
void announce(vtkInformation* out, const VtkExtent& whole);

/// The piece that the output's information asks for in RequestData.
[[nodiscard]] VtkExtent update_extent(vtkInformation* out);

/// \throws InvalidField if the input at hand does not cover what the piece needs.
void check_input(const VtkExtent& held, const StructuredPiece& piece);

/// What is at hand of an image or structured grid, for a piece of the result.
/// \throws InvalidField see check_input
template <class Structured>
[[nodiscard]] HeldInput held_for(const StructuredPiece& piece, Structured* input) {
  HeldInput held;
  input->GetExtent(held.extent.data());
  held.ghosts = input->GetPointGhostArray();
  check_input(held.extent, piece);
  return held;
}

/// Point arrays, vtkGhostType and cell data of `input` to those of `output`. `type`: 0 or
/// VTK_FLOAT or VTK_DOUBLE. False if aborted.
bool refine_attributes(vtkDataSet* input, vtkDataSet* output, const StructuredPiece& piece,
                       const HeldInput& held, const PointRefiner& refiner, PointRule rule, int type,
                       Work& work);
/// How much work that is.
[[nodiscard]] double attribute_steps(vtkDataSet* input, const PointRefiner& refiner);

}  // namespace arete::vtk_filters
