// SPDX-License-Identifier: MIT
#include "arete/vtk/internal/shapes.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <cmath>
#include <numbers>

namespace arete::vtk {

void Shapes::disc(Pixel centre, double radius) {
  constexpr int corners = 24;
  cells_->InsertNextCell(corners);
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / corners;
    add(centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle));
  }
}

void Shapes::box(Pixel low, Pixel high) {
  cells_->InsertNextCell(4);
  add(low.x, low.y);
  add(high.x, low.y);
  add(high.x, high.y);
  add(low.x, high.y);
}

void Shapes::line(const std::vector<Pixel>& points, bool closed, double width) {
  for (std::size_t k = 0; k < points.size(); ++k) {
    disc(points[k], width / 2);
    if (k + 1 < points.size() || closed) {
      segment(points[k], points[(k + 1) % points.size()], width);
    }
  }
}

void Shapes::draw(const Rgb& color, vtkRenderer& renderer) const {
  vtkNew<vtkPolyData> data;
  data->SetPoints(points_);
  data->SetPolys(cells_);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
  actor->GetProperty()->LightingOff();
  renderer.AddActor(actor);
}

void Shapes::add(double x, double y) {
  cells_->InsertCellPoint(points_->InsertNextPoint(x, y, layer_));
}

void Shapes::segment(Pixel a, Pixel b, double width) {
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  if (!(length > 0)) return;
  const double nx = -(b.y - a.y) / length * width / 2;
  const double ny = (b.x - a.x) / length * width / 2;
  cells_->InsertNextCell(4);
  add(a.x + nx, a.y + ny);
  add(a.x - nx, a.y - ny);
  add(b.x - nx, b.y - ny);
  add(b.x + nx, b.y + ny);
}

void set_pixel_camera(int width, int height, vtkRenderer& renderer) {
  vtkCamera& camera = *renderer.GetActiveCamera();
  camera.ParallelProjectionOn();
  camera.SetParallelScale(height / 2.0);
  camera.SetFocalPoint(width / 2.0, height / 2.0, 0);
  camera.SetPosition(width / 2.0, height / 2.0, 10);
  camera.SetClippingRange(1, 20);
}

}  // namespace arete::vtk
