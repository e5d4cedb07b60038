// SPDX-License-Identifier: MIT
#include "arete/vtk/internal/painter.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <utility>

namespace arete::vtk {

void Painter::boxes(const std::vector<std::array<double, 4>>& corners,
                    const std::vector<Rgb>& colors) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> quads;
  vtkNew<vtkUnsignedCharArray> colored;
  colored->SetNumberOfComponents(3);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto [x0, y0, x1, y1] = corners[k];
    quads->InsertNextCell(4);
    for (const auto& [x, y] : {std::pair{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}) {
      quads->InsertCellPoint(
          points->InsertNextPoint(std::round(x * scale_), std::round(y * scale_), 0));
      colored->InsertNextTypedTuple(colors[k].data());
    }
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(quads);
  data->GetPointData()->SetScalars(colored);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  renderer_.AddViewProp(actor);
}

void Painter::text(const std::string& words, double x, double y, double size, TextPlace place) {
  vtkNew<vtkTextActor> actor;
  actor->SetInput(words.c_str());
  vtkTextProperty* property = actor->GetTextProperty();
  property->SetFontSize(static_cast<int>(std::lround(size * scale_)));
  property->SetColor(ink_[0] / 255.0, ink_[1] / 255.0, ink_[2] / 255.0);
  switch (place) {
    case TextPlace::right:
      property->SetVerticalJustificationToBottom();
      break;
    case TextPlace::right_middle:
      property->SetVerticalJustificationToCentered();
      break;
    case TextPlace::left_middle:
      property->SetJustificationToRight();
      property->SetVerticalJustificationToCentered();
      break;
    case TextPlace::below:
      property->SetJustificationToCentered();
      property->SetVerticalJustificationToTop();
      break;
    case TextPlace::above_turned:
      property->SetOrientation(90);
      property->SetJustificationToCentered();
      property->SetVerticalJustificationToBottom();
      break;
  }
  actor->SetPosition(std::round(x * scale_), std::round(y * scale_));
  renderer_.AddViewProp(actor);
}

}  // namespace arete::vtk
