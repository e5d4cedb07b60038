// SPDX-License-Identifier: MIT
#include "arete/vtk/internal/point_arrays.h"

#include <vtkDataSet.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "arete/vtk/internal/gradient.h"

namespace arete::vtk {
namespace {

template <class Array, class T>
void add_heights(const GridView<const T>& heights, Index count, const SampleOf& sample_of,
                 vtkDataSet& out) {
  vtkNew<Array> array;
  array->SetName("height");
  array->SetNumberOfValues(count);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(count);
  bool complete = true;
  for (Index point = 0; point < count; ++point) {
    const Sample sample = sample_of(point);
    const T height = heights(sample.row, sample.col);
    const bool valid = std::isfinite(height);
    array->SetValue(point, height);
    ghosts->SetValue(point, valid ? 0 : vtkDataSetAttributes::HIDDENPOINT);
    complete = complete && valid;
  }
  out.GetPointData()->SetScalars(array);
  if (!complete) out.GetPointData()->AddArray(ghosts);
}

double lowest(const Surface& surface, Index count, const SampleOf& sample_of) {
  double low = std::numeric_limits<double>::infinity();
  for (Index point = 0; point < count; ++point) {
    const Sample sample = sample_of(point);
    const double height = surface.height(sample.row, sample.col);
    if (std::isfinite(height)) low = std::min(low, height);
  }
  return low;
}

}  // namespace

void add_heights(const Surface& surface, Index count, const SampleOf& sample_of, vtkDataSet& out) {
  if (const auto* floats = std::get_if<GridView<const float>>(&surface.heights)) {
    add_heights<vtkFloatArray>(*floats, count, sample_of, out);
  } else {
    add_heights<vtkDoubleArray>(std::get<GridView<const double>>(surface.heights), count, sample_of,
                                out);
  }
}

void add_surface_points(const Surface& surface, const LocalPlane& plane, Index count,
                        const SampleOf& sample_of, vtkPointSet& out) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  vtkNew<vtkFloatArray> slope;
  slope->SetName("slope");
  slope->SetNumberOfValues(count);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(count);

  const GradientField gradients(surface, plane);
  const double low = lowest(surface, count, sample_of);
  for (Index point = 0; point < count; ++point) {
    const auto [row, col] = sample_of(point);
    const WorldPoint at =
        plane.placement.position(static_cast<double>(row), static_cast<double>(col));
    const bool valid = surface.valid(row, col);
    points->SetPoint(point, at.x, at.y, valid ? surface.height(row, col) : low);

    const Gradient g = gradients.at(row, col);
    const double steepness = std::hypot(g.dx, g.dy);
    slope->SetValue(point, valid ? static_cast<float>(std::atan(steepness) * 180 / std::numbers::pi)
                                 : std::numeric_limits<float>::quiet_NaN());
    const double length = std::hypot(1, steepness);
    normals->SetTuple3(point, -g.dx / length, -g.dy / length, 1 / length);
  }
  out.SetPoints(points);
  add_heights(surface, count, sample_of, out);
  out.GetPointData()->AddArray(slope);
  out.GetPointData()->SetNormals(normals);
}

}  // namespace arete::vtk
