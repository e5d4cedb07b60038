// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "internal/plane.h"
#include "vtkSmartPointer.h"

class vtkDataSetAttributes;

namespace arete::vtk_filters {

/// How numbers of points are taken to the new points.
enum class PointRule {
  scheme,  ///< by the weights of the scheme
  linear   ///< bilinearly between the old points around
};

/// Refines arrays of a structured data set over one piece, slice by slice.
class PointRefiner {
 public:
  PointRefiner(const StructuredPiece& piece, const HeldInput& held, int threads);

  /// How much work an array is.
  [[nodiscard]] double steps(vtkDataArray* array) const;
  [[nodiscard]] Index points() const;

  /// Fills `result` (float or double, sized, same components). False if aborted.
  bool refine(vtkDataArray* array, vtkDataArray* result, PointRule rule, Work& work) const;

  /// Marks the result's points that lie in no whole cell of visible points.
  bool mark_hidden(vtkUnsignedCharArray* result, Work& work) const;

 private:
  template <class T>
  bool refine_as(vtkDataArray* array, vtkDataArray* result, PointRule rule, Work& work) const;

  const StructuredPiece& piece_;
  HeldInput held_;
  Refiner<float> single_;
  Refiner<double> double_;
};

/// The arrays of points that can be refined: numbers, but neither ids nor ghost flags.
[[nodiscard]] std::vector<vtkDataArray*> refinable_arrays(vtkDataSetAttributes* data);

/// An array of the name and components of `array` with `tuples` tuples, in its refined type or in
/// `type`. Attribute roles are kept by add_like().
[[nodiscard]] vtkSmartPointer<vtkDataArray> refined_like(vtkDataArray* array, Index tuples,
                                                         int type);
/// Adds `result` to `out` in the role (scalars, normals, ...) that `array` has in `in`; normals get
/// their length 1 back.
void add_like(vtkDataSetAttributes* in, vtkDataArray* array, vtkDataSetAttributes* out,
              vtkDataArray* result);

}  // namespace arete::vtk_filters
