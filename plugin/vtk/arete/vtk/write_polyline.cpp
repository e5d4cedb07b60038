// SPDX-License-Identifier: MIT
#include "arete/vtk/write_polyline.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "arete/vtk/internal/xml_file.h"

namespace arete::vtk {

void check_polyline(const Polyline& line) {
  const auto& points = line.points;
  if (points.cols() != 2 && points.cols() != 3) {
    throw InvalidField("a curve has 2 or 3 coordinates a point, not " +
                       std::to_string(points.cols()));
  }
  const Index least = line.closed ? 3 : 2;
  if (points.rows() < least) {
    throw InvalidField(std::string(line.closed ? "a closed" : "an open") +
                       " curve needs at least " + std::to_string(least) + " points, not " +
                       std::to_string(points.rows()));
  }
  for (Index r = 0; r < points.rows(); ++r) {
    for (Index c = 0; c < points.cols(); ++c) {
      if (!std::isfinite(points(r, c))) {
        throw InvalidField("point " + std::to_string(r) + " of the curve is not finite");
      }
    }
  }
  if (!line.tau.empty() && std::ssize(line.tau) != points.rows()) {
    throw InvalidField(std::to_string(line.tau.size()) + " parameters do not fit " +
                       std::to_string(points.rows()) + " points");
  }
}

void write_polyline(const Polyline& line, const std::filesystem::path& path,
                    const WriteOptions& options) {
  check_polyline(line);
  const Index count = line.points.rows();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(static_cast<int>(count) + (line.closed ? 1 : 0));
  for (Index r = 0; r < count; ++r) {
    const double z = line.points.cols() == 3 ? line.points(r, 2) : 0.0;
    points->SetPoint(r, line.points(r, 0), line.points(r, 1), z);
    cells->InsertCellPoint(r);
  }
  if (line.closed) cells->InsertCellPoint(0);

  vtkNew<vtkPolyData> curve;
  curve->SetPoints(points);
  curve->SetLines(cells);
  if (!line.tau.empty()) {
    vtkNew<vtkDoubleArray> tau;
    tau->SetName("tau");
    tau->SetNumberOfValues(count);
    std::copy(line.tau.begin(), line.tau.end(), tau->GetPointer(0));
    curve->GetPointData()->SetScalars(tau);
  }
  vtkNew<vtkXMLPolyDataWriter> writer;
  write_xml(*writer, *curve, path, options);
}

}  // namespace arete::vtk
