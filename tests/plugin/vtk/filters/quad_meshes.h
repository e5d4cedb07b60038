// SPDX-License-Identifier: MIT
#pragma once

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStructuredGrid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

#include "arete/field/grid.h"

namespace arete::test {

/// Points with the given coordinates, row r of the planes at j = r.
inline vtkSmartPointer<vtkPoints> points_of(const std::array<Grid<double>, 3>& planes) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  for (std::size_t i = 0; i < planes[0].samples().size(); ++i)
    points->InsertNextPoint(planes[0].samples()[i], planes[1].samples()[i], planes[2].samples()[i]);
  return points;
}

inline vtkSmartPointer<vtkStructuredGrid> structured_grid(const std::array<Grid<double>, 3>& planes,
                                                          std::array<int, 2> begin = {0, 0}) {
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetExtent(begin[0], begin[0] + static_cast<int>(planes[0].cols()) - 1, begin[1],
                  begin[1] + static_cast<int>(planes[0].rows()) - 1, 0, 0);
  grid->SetPoints(points_of(planes));
  return grid;
}

/// x = c, y = -r (so that rows run south as in a raster), z as given.
inline std::array<Grid<double>, 3> terrain(const Grid<double>& heights) {
  std::array<Grid<double>, 3> planes{heights, heights, heights};
  for (Index r = 0; r < heights.rows(); ++r) {
    for (Index c = 0; c < heights.cols(); ++c) {
      planes[0](r, c) = static_cast<double>(c);
      planes[1](r, c) = -static_cast<double>(r);
    }
  }
  return planes;
}

enum class Faces { quads, main_diagonals, anti_diagonals };

/// The same surface as polygons, counter-clockwise seen from above for terrain(); points and faces
/// in random order, faces beginning anywhere. `wraps`: the last column is followed by the first.
inline vtkSmartPointer<vtkPolyData> polygons(const std::array<Grid<double>, 3>& planes, Faces kind,
                                             bool wraps = false, unsigned seed = 1) {
  const Index rows = planes[0].rows();
  const Index cols = planes[0].cols();
  std::mt19937 random(seed);
  std::vector<vtkIdType> ids(static_cast<std::size_t>(rows * cols));
  std::iota(ids.begin(), ids.end(), 0);
  std::shuffle(ids.begin(), ids.end(), random);
  const auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(rows * cols);
  for (std::size_t i = 0; i < ids.size(); ++i)
    points->SetPoint(ids[i], planes[0].samples()[i], planes[1].samples()[i],
                     planes[2].samples()[i]);
  std::vector<std::vector<vtkIdType>> faces;
  for (Index r = 0; r + 1 < rows; ++r) {
    for (Index c = 0; c + (wraps ? 0 : 1) < cols; ++c) {
      const auto id = [&](Index i, Index j) {
        return ids[static_cast<std::size_t>(i * cols + j % cols)];
      };
      const vtkIdType a = id(r, c), b = id(r + 1, c), d = id(r + 1, c + 1), e = id(r, c + 1);
      if (kind == Faces::quads) faces.push_back({a, b, d, e});
      if (kind == Faces::main_diagonals) {
        faces.push_back({a, b, d});
        faces.push_back({a, d, e});
      }
      if (kind == Faces::anti_diagonals) {
        faces.push_back({a, b, e});
        faces.push_back({b, d, e});
      }
    }
  }
  std::shuffle(faces.begin(), faces.end(), random);
  const vtkNew<vtkCellArray> cells;
  for (auto& face : faces) {
    std::rotate(face.begin(), face.begin() + static_cast<long>(random() % face.size()), face.end());
    cells->InsertNextCell(static_cast<vtkIdType>(face.size()), face.data());
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh;
}

}  // namespace arete::test
