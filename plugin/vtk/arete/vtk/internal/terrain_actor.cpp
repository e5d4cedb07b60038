// SPDX-License-Identifier: MIT
#include "arete/vtk/internal/terrain_actor.h"

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>

#include "arete/vtk/internal/gradient.h"
#include "arete/vtk/internal/quads.h"
#include "arete/vtk/internal/sky_view.h"

namespace arete::vtk {
namespace {

constexpr double sky_share = 0.5;  // of a colour's brightness that sky view decides

Rgb dimmed(Rgb color, double sky) {
  const double factor = 1 - sky_share * (1 - sky);
  for (auto& channel : color) channel = static_cast<std::uint8_t>(std::lround(channel * factor));
  return color;
}

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

}  // namespace

Rgb HeightColors::operator()(double height) const {
  if (colors == nullptr) return {255, 255, 255};
  return (*colors)(high > low ? (height - low) / (high - low) : 0.5);
}

std::vector<Vector3> set_terrain(const Stage& stage, const HeightColors& colors, vtkActor& actor) {
  const Surface& surface = stage.surface();
  vtkNew<vtkPolyData> mesh;
  const std::vector<Index> samples = set_quads(surface, *mesh);
  if (samples.empty()) {
    throw InvalidField("no four neighbouring samples are all valid: there is nothing to draw");
  }
  const auto count = static_cast<Index>(samples.size());
  const auto normals = tuples(3, count);
  const auto on_texture = tuples(2, count);
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(count);
  vtkNew<vtkUnsignedCharArray> colored;
  colored->SetNumberOfComponents(3);
  colored->SetNumberOfTuples(count);

  const Extent extent = surface.extent();
  const GradientField gradients(surface, stage.plane());
  const Grid<float> sky = sky_view(surface, stage.plane(), stage.exaggeration());
  std::vector<Vector3> places;
  places.reserve(samples.size());
  for (Index point = 0; point < count; ++point) {
    const Index row = samples[static_cast<std::size_t>(point)] / extent.cols;
    const Index col = samples[static_cast<std::size_t>(point)] % extent.cols;
    places.push_back(stage.place(row, col));
    points->SetPoint(point, places.back().data());
    normals->SetTuple(point, normal(gradients.at(row, col), stage.exaggeration()).data());
    // A texture covers the raster's box, half a sample wider than its samples.
    on_texture->SetTuple2(point,
                          (static_cast<double>(col) + 0.5) / static_cast<double>(extent.cols),
                          1 - (static_cast<double>(row) + 0.5) / static_cast<double>(extent.rows));
    const Rgb color = dimmed(colors(surface.height(row, col)), sky(row, col));
    colored->SetTypedTuple(point, color.data());
  }
  mesh->SetPoints(points);
  mesh->GetPointData()->SetNormals(normals);
  mesh->GetPointData()->SetTCoords(on_texture);
  mesh->GetPointData()->SetScalars(colored);

  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  mapper->SetColorModeToDirectScalars();
  actor.SetMapper(mapper);
  vtkProperty* property = actor.GetProperty();
  property->SetAmbient(0.36);
  property->SetDiffuse(0.86);
  property->SetSpecular(0.04);
  property->SetSpecularPower(15);
  return places;
}

}  // namespace arete::vtk
