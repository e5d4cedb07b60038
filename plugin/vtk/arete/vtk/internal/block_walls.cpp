// SPDX-License-Identifier: MIT
#include "arete/vtk/internal/block_walls.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <cmath>
#include <cstdint>
#include <utility>

#include "arete/vtk/internal/quads.h"
#include "arete/vtk/internal/sample_order.h"

namespace arete::vtk {
namespace {

/// Which quads lie outside the terrain: missing ones that reach the border of the raster through
/// missing ones, and a frame of one quad around the raster.
class Outside {
 public:
  explicit Outside(const Surface& surface)
      : extent_(surface.extent()), outside_({extent_.rows + 1, extent_.cols + 1}, 0) {
    std::vector<Sample> open{{-1, -1}};
    while (!open.empty()) {
      const auto [row, col] = open.back();
      open.pop_back();
      if (row < -1 || col < -1 || row >= extent_.rows || col >= extent_.cols) continue;
      if ((*this)(row, col) || whole_quad(surface, row, col)) continue;
      outside_(row + 1, col + 1) = 1;
      open.insert(open.end(), {{row - 1, col}, {row + 1, col}, {row, col - 1}, {row, col + 1}});
    }
  }

  /// Quads are named by their least row and column, from -1 to rows - 1 and cols - 1.
  [[nodiscard]] bool operator()(Index row, Index col) const {
    return outside_(row + 1, col + 1) != 0;
  }

 private:
  Extent extent_;
  Grid<std::uint8_t> outside_;
};

class Walls {
 public:
  Walls(const Stage& stage, double foot) : stage_(stage), foot_(foot) {
    normals_->SetNumberOfComponents(3);
  }

  /// A wall under the edge from a to b; its outer side is the one `outwards` points to.
  void add(Sample a, Sample b, const Vector3& outwards) {
    Vector3 top_a = stage_.place(a.row, a.col);
    Vector3 top_b = stage_.place(b.row, b.col);
    double nx = top_b[1] - top_a[1];
    double ny = top_a[0] - top_b[0];
    if (nx * outwards[0] + ny * outwards[1] < 0) {
      std::swap(a, b);
      std::swap(top_a, top_b);
      nx = -nx;
      ny = -ny;
    }
    const double length = std::hypot(nx, ny);
    cells_->InsertNextCell(4);
    for (const Vector3& corner :
         {stage_.place(a.row, a.col, foot_), stage_.place(b.row, b.col, foot_), top_b, top_a}) {
      cells_->InsertCellPoint(points_->InsertNextPoint(corner.data()));
      normals_->InsertNextTuple3(nx / length, ny / length, 0);
      places_.push_back(corner);
    }
  }

  void set(vtkActor& actor) {
    vtkNew<vtkPolyData> mesh;
    mesh->SetPoints(points_);
    mesh->SetPolys(cells_);
    mesh->GetPointData()->SetNormals(normals_);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(mesh);
    actor.SetMapper(mapper);
  }

  [[nodiscard]] const std::vector<Vector3>& places() const { return places_; }

 private:
  const Stage& stage_;
  double foot_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> cells_;
  vtkNew<vtkFloatArray> normals_;
  std::vector<Vector3> places_;
};

Vector3 difference(const Vector3& a, const Vector3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

}  // namespace

std::vector<Vector3> set_block_walls(const Stage& stage, double foot, vtkActor& actor) {
  const Surface& surface = stage.surface();
  const Extent extent = surface.extent();
  const Outside outside(surface);
  Walls walls(stage, foot);
  for (Index row = 0; row + 1 < extent.rows; ++row) {
    for (Index col = 0; col + 1 < extent.cols; ++col) {
      if (!whole_quad(surface, row, col)) continue;
      const Vector3 along_row = difference(stage.place(row, col + 1, 0), stage.place(row, col, 0));
      const Vector3 along_col = difference(stage.place(row + 1, col, 0), stage.place(row, col, 0));
      const Vector3 back_row = difference({0, 0, 0}, along_row);
      const Vector3 back_col = difference({0, 0, 0}, along_col);
      if (outside(row - 1, col)) walls.add({row, col}, {row, col + 1}, back_col);
      if (outside(row + 1, col)) walls.add({row + 1, col}, {row + 1, col + 1}, along_col);
      if (outside(row, col - 1)) walls.add({row, col}, {row + 1, col}, back_row);
      if (outside(row, col + 1)) walls.add({row, col + 1}, {row + 1, col + 1}, along_row);
    }
  }
  walls.set(actor);
  vtkProperty* property = actor.GetProperty();
  property->SetColor(0.72, 0.68, 0.62);
  property->SetAmbient(0.75);
  property->SetDiffuse(0.4);
  property->BackfaceCullingOn();  // seen through a hole, a wall from within would be no wall
  return walls.places();
}

}  // namespace arete::vtk
