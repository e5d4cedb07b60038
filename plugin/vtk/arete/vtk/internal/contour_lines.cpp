// SPDX-License-Identifier: MIT
#include "arete/vtk/internal/contour_lines.h"

#include <vtkCellArray.h>
#include <vtkContourFilter.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>

namespace arete::vtk {

namespace {

vtkNew<vtkDoubleArray> held_values(const Grid<double>& field, const char* name) {
  vtkNew<vtkDoubleArray> values;
  values->SetName(name);
  for (const double value : field.samples()) values->InsertNextValue(std::clamp(value, -1.0, 1.0));
  return values;
}

// Bilinear between the samples.
double value_at(const Grid<double>& field, double col, double row) {
  const Index c = std::min(static_cast<Index>(col), field.cols() - 2);
  const Index r = std::min(static_cast<Index>(row), field.rows() - 2);
  const double u = col - static_cast<double>(c);
  const double v = row - static_cast<double>(r);
  const auto at = [&](Index i, Index j) { return std::clamp(field(i, j), -1.0, 1.0); };
  return (1 - v) * ((1 - u) * at(r, c) + u * at(r, c + 1)) +
         v * ((1 - u) * at(r + 1, c) + u * at(r + 1, c + 1));
}

}  // namespace

std::vector<std::array<std::array<double, 2>, 2>> zero_lines(const Grid<double>& field,
                                                             const Grid<double>& within) {
  vtkNew<vtkImageData> image;
  image->SetDimensions(static_cast<int>(field.cols()), static_cast<int>(field.rows()), 1);
  image->GetPointData()->SetScalars(held_values(field, "field"));
  vtkNew<vtkContourFilter> contour;
  contour->SetInputData(image);
  contour->SetValue(0, 0.0);
  contour->Update();
  std::vector<std::array<std::array<double, 2>, 2>> pieces;
  vtkPolyData* lines = contour->GetOutput();
  vtkNew<vtkIdList> ends;
  for (vtkIdType cell = 0; cell < lines->GetNumberOfCells(); ++cell) {
    lines->GetCellPoints(cell, ends);
    for (vtkIdType k = 0; k + 1 < ends->GetNumberOfIds(); ++k) {
      const vtkIdType first = ends->GetId(k), second = ends->GetId(k + 1);
      double a[3], b[3];
      lines->GetPoint(first, a);
      lines->GetPoint(second, b);
      // Sampled here: for images VTK's filter carries no array but the contoured one.
      if (within.rows() > 0 && value_at(within, (a[0] + b[0]) / 2, (a[1] + b[1]) / 2) >= 0) continue;
      pieces.push_back({{{a[0], a[1]}, {b[0], b[1]}}});
    }
  }
  return pieces;
}

}  // namespace arete::vtk
