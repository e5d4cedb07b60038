// SPDX-License-Identifier: MIT
#include "internal/plane.h"

#include <limits>

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkUnsignedCharArray.h"

namespace arete::vtk_filters {
namespace {

// Enough rows to keep every thread busy, few enough for progress and abort to be prompt.
Index band_rows(Index cols) {
  return std::clamp((Index{1} << 21) / std::max(cols, Index{1}), Index{64}, Index{2048});
}

// `value(point)` is one component at a point id.
template <class T, class Value>
Grid<T> gather(const Value& value, int k, const StructuredPiece& piece, const HeldInput& held) {
  Grid<T> plane(piece.window().extent());
  const VtkExtent& e = held.extent;
  const Index width = count_along(e, 0);
  const Index slice = width * count_along(e, 1) * (k - e[4]);
  for (Index r = 0; r < plane.rows(); ++r) {
    const Index row = slice + width * (piece.input_j(r) - e[2]) - e[0];
    for (Index c = 0; c < plane.cols(); ++c) {
      const Index point = row + piece.input_i(c);
      const bool hidden =
          held.ghosts && (held.ghosts->GetValue(point) & vtkDataSetAttributes::HIDDENPOINT) != 0;
      plane(r, c) = hidden ? std::numeric_limits<T>::quiet_NaN() : value(point);
    }
  }
  return plane;
}

}  // namespace

template <class T>
Grid<T> read_plane(vtkDataArray* array, int component, int k, const StructuredPiece& piece,
                   const HeldInput& held) {
  if (!array) return gather<T>([](Index) { return T(0); }, k, piece, held);
  if (array->HasStandardMemoryLayout()) {
    const int step = array->GetNumberOfComponents();
    switch (array->GetDataType()) {
      vtkTemplateMacro(
          return gather<T>([data = static_cast<const VTK_TT*>(array->GetVoidPointer(0)) + component,
                            step](Index point) { return static_cast<T>(data[point * step]); },
                           k, piece, held));
      default:
        break;
    }
  }
  return gather<T>(
      [&](Index point) { return static_cast<T>(array->GetComponent(point, component)); }, k, piece,
      held);
}

int refined_type(int vtk_type) {
  switch (vtk_type) {
    case VTK_FLOAT:
    case VTK_BIT:
    case VTK_CHAR:
    case VTK_SIGNED_CHAR:
    case VTK_UNSIGNED_CHAR:
    case VTK_SHORT:
    case VTK_UNSIGNED_SHORT:
      return VTK_FLOAT;
    default:
      return VTK_DOUBLE;
  }
}

template <class T>
bool refine_in_bands(const Refiner<T>& refiner, const Grid<T>& plane, Work& work,
                     const std::function<void(Index first_row, GridView<const T> band)>& take) {
  const Extent size = refiner.output();
  const GridSource<T> source(plane.view());
  Grid<T> band({std::min(size.rows, band_rows(size.cols)), size.cols});
  for (Index first = 0; first < size.rows; first += band.rows()) {
    const GridView<T> rows(band.row(0), {std::min(band.rows(), size.rows - first), size.cols});
    refiner.refine_rows(source, first, rows);
    take(first, rows);
    if (!work.done(static_cast<double>(rows.rows()))) return false;
  }
  return true;
}

template <class T>
bool refine_plane(const Refiner<T>& refiner, const Grid<T>& plane, vtkDataArray* result,
                  int component, Index first_tuple, Work& work) {
  const Extent size = refiner.output();
  const int step = result->GetNumberOfComponents();
  T* data = static_cast<T*>(result->GetVoidPointer(0)) + first_tuple * step + component;
  if (step > 1)
    return refine_in_bands<T>(refiner, plane, work, [&](Index first, GridView<const T> band) {
      T* out = data + first * size.cols * step;
      for (Index r = 0; r < band.rows(); ++r)
        for (Index c = 0; c < band.cols(); ++c, out += step) *out = band(r, c);
    });
  // One component: straight into the array.
  const GridSource<T> source(plane.view());
  const Index height = band_rows(size.cols);
  for (Index first = 0; first < size.rows; first += height) {
    const Index rows = std::min(height, size.rows - first);
    refiner.refine_rows(source, first, GridView<T>(data + first * size.cols, {rows, size.cols}));
    if (!work.done(static_cast<double>(rows))) return false;
  }
  return true;
}

template Grid<float> read_plane(vtkDataArray*, int, int, const StructuredPiece&, const HeldInput&);
template Grid<double> read_plane(vtkDataArray*, int, int, const StructuredPiece&, const HeldInput&);
template bool refine_plane(const Refiner<float>&, const Grid<float>&, vtkDataArray*, int, Index,
                           Work&);
template bool refine_plane(const Refiner<double>&, const Grid<double>&, vtkDataArray*, int, Index,
                           Work&);
template bool refine_in_bands(const Refiner<float>&, const Grid<float>&, Work&,
                              const std::function<void(Index, GridView<const float>)>&);
template bool refine_in_bands(const Refiner<double>&, const Grid<double>&, Work&,
                              const std::function<void(Index, GridView<const double>)>&);

}  // namespace arete::vtk_filters
