// SPDX-License-Identifier: MIT
#include "arete/vtk/internal/terrain_mesh.h"

#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <cmath>

#include "arete/vtk/internal/gradient.h"
#include "arete/vtk/internal/quads.h"

namespace arete::vtk {
namespace {

Vector3 normal(const Gradient& gradient, double exaggeration) {
  const double dx = gradient.dx * exaggeration;
  const double dy = gradient.dy * exaggeration;
  const double length = std::hypot(1, dx, dy);
  return {-dx / length, -dy / length, 1 / length};
}

vtkNew<vtkFloatArray> tuples(int components, Index count) {
  vtkNew<vtkFloatArray> array;
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(count);
  return array;
}

/// Of a sample, from 0 to 1 over the box.
double share(Index sample, const AxisPlacement& axis, Index extent) {
  return (axis.first + static_cast<double>(sample) * axis.spacing + 0.5) /
         static_cast<double>(extent);
}

}  // namespace

std::vector<Vector3> TerrainMesh::points() const {
  std::vector<Vector3> points(samples.size());
  for (std::size_t k = 0; k < points.size(); ++k)
    data->GetPoint(static_cast<Index>(k), points[k].data());
  return points;
}

TerrainMesh terrain_mesh(const Stage& stage, const TextureBox& box) {
  const Surface& surface = stage.surface();
  TerrainMesh mesh{vtkSmartPointer<vtkPolyData>::New(), {}};
  const std::vector<Index> samples = set_quads(surface, *mesh.data);
  if (samples.empty())
    throw InvalidField("no four neighbouring samples are all valid: there is nothing to draw");
  const auto count = static_cast<Index>(samples.size());
  const auto normals = tuples(3, count);
  const auto on_texture = tuples(2, count);
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(count);
  mesh.samples.reserve(samples.size());
  const GradientField gradients(surface, stage.plane());
  const Index cols = surface.extent().cols;
  for (Index point = 0; point < count; ++point) {
    const Index sample = samples[static_cast<std::size_t>(point)];
    const auto [row, col] = mesh.samples.emplace_back(Sample{sample / cols, sample % cols});
    points->SetPoint(point, stage.place(row, col).data());
    normals->SetTuple(point, normal(gradients.at(row, col), stage.exaggeration()).data());
    on_texture->SetTuple2(point, share(col, box.cols, box.extent.cols),
                          1 - share(row, box.rows, box.extent.rows));
  }
  mesh.data->SetPoints(points);
  mesh.data->GetPointData()->SetNormals(normals);
  mesh.data->GetPointData()->SetTCoords(on_texture);
  return mesh;
}

}  // namespace arete::vtk
