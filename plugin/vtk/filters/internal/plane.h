// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "arete/refine/refiner.h"
#include "internal/structured_piece.h"
#include "internal/work.h"

class vtkDataArray;
class vtkUnsignedCharArray;

namespace arete::vtk_filters {

/// The values of a structured data set in memory: the extent they cover and which points are hidden
/// (vtkGhostType), if any may be.
struct HeldInput {
  VtkExtent extent{};
  vtkUnsignedCharArray* ghosts = nullptr;
};

/// One component of an array in slice k, over the window of a piece. NaN at hidden points.
/// A null array is one of zeros. T is float or double.
template <class T>
[[nodiscard]] Grid<T> read_plane(vtkDataArray* array, int component, int k,
                                 const StructuredPiece& piece, const HeldInput& held);

/// The type in which a refined array is kept: float for float and integers of up to 16
/// bits, double for all others.
[[nodiscard]] int refined_type(int vtk_type);

/// Refines a plane to the tuples first_tuple, first_tuple + 1, ... (row by row) of one component of
/// `result`, which holds T. False if aborted.
template <class T>
bool refine_plane(const Refiner<T>& refiner, const Grid<T>& plane, vtkDataArray* result,
                  int component, Index first_tuple, Work& work);

/// The same for every band of result rows, for whoever does not want them in an array.
template <class T>
bool refine_in_bands(const Refiner<T>& refiner, const Grid<T>& plane, Work& work,
                     const std::function<void(Index first_row, GridView<const T> band)>& take);

}  // namespace arete::vtk_filters
