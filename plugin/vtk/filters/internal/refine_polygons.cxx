// SPDX-License-Identifier: MIT
#include "internal/refine_polygons.h"

#include <cmath>
#include <limits>
#include <string>

#include "arete/topology/orient.h"
#include "arete/topology/recover.h"
#include "internal/bilinear.h"
#include "internal/cell_data.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace arete::vtk_filters {
namespace {

// A patch with the plans of its axes.
struct RefinedPatch {
  GridPatch patch;
  AxisPlan x;
  AxisPlan y;
  vtkIdType first_point = 0;

  [[nodiscard]] Index points() const { return x.output_count() * y.output_count(); }
  [[nodiscard]] Index cell_rows() const { return y.output_count() - (patch.wraps_rows ? 0 : 1); }
  [[nodiscard]] Index cell_cols() const { return x.output_count() - (patch.wraps_cols ? 0 : 1); }
  [[nodiscard]] vtkIdType point(Index r, Index c) const {
    return first_point + (r % y.output_count()) * x.output_count() + c % x.output_count();
  }
};

void check_kinds(vtkPolyData* input) {
  if (input->GetNumberOfVerts() + input->GetNumberOfLines() + input->GetNumberOfStrips() > 0)
    throw InvalidField(
        "the input holds vertices, lines or strips besides polygons; keep the polygons only "
        "(strips: vtkTriangleFilter)");
  if (input->GetNumberOfPoints() > std::numeric_limits<int>::max())
    throw InvalidField("the input has more points than can be told apart; cut it into parts");
}

FaceList faces_of(vtkPolyData* input) {
  FaceList faces;
  vtkCellArray* polygons = input->GetPolys();
  std::vector<int> corners;
  for (vtkIdType f = 0; f < polygons->GetNumberOfCells(); ++f) {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    polygons->GetCellAtId(f, size, ids);
    corners.assign(ids, ids + size);
    faces.add(corners);
  }
  return faces;
}

std::vector<Point3> positions_of(vtkPolyData* input) {
  std::vector<Point3> positions(static_cast<std::size_t>(input->GetNumberOfPoints()));
  for (std::size_t i = 0; i < positions.size(); ++i) {
    input->GetPoint(static_cast<vtkIdType>(i), positions[i].data());
    for (const double coordinate : positions[i])
      if (!std::isfinite(coordinate))
        throw InvalidField("point " + std::to_string(i) +
                           " has a coordinate that is not finite; remove it with its cells");
  }
  return positions;
}

AxisPlan plan_axis(const Scheme& scheme, Index count, bool wraps, Boundary boundary, int levels,
                   bool limit) {
  if (!wraps && boundary == Boundary::periodic)
    throw InvalidField(
        "boundary periodic would bend an open rim to the other side; choose another boundary");
  AxisOptions options{
      levels, wraps ? Boundary::periodic : boundary, Alignment::nodes, {}, FinalResult::samples};
  if (limit) options.final_stencil = required_limit_of(scheme);
  AxisPlan plan(scheme.mask(), count, options);
  if (plan.output_count() < (wraps ? 3 : 2))
    throw InvalidField("boundary none leaves " + std::to_string(plan.output_count()) +
                       " points along an axis, too few for a polygon; choose another boundary");
  return plan;
}

template <class T>
bool refine_points_as(const RefinedPatch& p, vtkDataArray* from, vtkDataArray* to, PointRule rule,
                      int threads, Work& work) {
  const int step = from->GetNumberOfComponents();
  T* out = static_cast<T*>(to->GetVoidPointer(0)) + p.first_point * step;
  const Refiner<T> refiner(p.x, p.y, threads);
  const auto rows = around(sample_places(p.y, {0, p.y.output_count() - 1}), p.y.input_count());
  const auto cols = around(sample_places(p.x, {0, p.x.output_count() - 1}), p.x.input_count());
  for (int component = 0; component < step; ++component) {
    Grid<T> plane(p.patch.extent);
    for (std::size_t i = 0; i < p.patch.vertices.size(); ++i)
      plane.samples()[i] = static_cast<T>(from->GetComponent(p.patch.vertices[i], component));
    if (rule == PointRule::scheme) {
      if (!refine_plane(refiner, plane, to, component, p.first_point, work)) return false;
      continue;
    }
    T* value = out + component;
    for (const Between& y : rows) {
      for (const Between& x : cols) {
        *value = bilinear(plane, y, x);
        value += step;
      }
      if (!work.done(1)) return false;
    }
  }
  return true;
}

bool refine_points(const std::vector<RefinedPatch>& patches, vtkDataArray* from, vtkDataArray* to,
                   PointRule rule, int threads, Work& work) {
  for (const RefinedPatch& p : patches) {
    const bool finished = to->GetDataType() == VTK_FLOAT
                              ? refine_points_as<float>(p, from, to, rule, threads, work)
                              : refine_points_as<double>(p, from, to, rule, threads, work);
    if (!finished) return false;
  }
  return true;
}

// Appends the polygons of a patch, turned as those of the input were, and tells their parents.
void append_polygons(const RefinedPatch& p, vtkCellArray* polygons,
                     std::vector<vtkIdType>& parents) {
  const std::vector<Index> rows = parent_cells(p.y, {0, p.cell_rows()}, p.patch.wraps_rows);
  const std::vector<Index> cols = parent_cells(p.x, {0, p.cell_cols()}, p.patch.wraps_cols);
  const auto insert = [&](std::initializer_list<vtkIdType> corners, int parent) {
    std::vector<vtkIdType> ids(corners);
    if (p.patch.mirrored) std::reverse(ids.begin(), ids.end());
    polygons->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    parents.push_back(parent);
  };
  for (Index r = 0; r < p.cell_rows(); ++r) {
    for (Index c = 0; c < p.cell_cols(); ++c) {
      const GridCell& parent =
          p.patch.cell(rows[static_cast<std::size_t>(r)], cols[static_cast<std::size_t>(c)]);
      const vtkIdType a = p.point(r, c), b = p.point(r, c + 1);
      const vtkIdType d = p.point(r + 1, c + 1), e = p.point(r + 1, c);
      switch (parent.diagonal) {
        case Diagonal::none:
          insert({a, b, d, e}, parent.faces[0]);
          break;
        case Diagonal::main:
          insert({a, b, d}, parent.faces[0]);
          insert({a, d, e}, parent.faces[1]);
          break;
        case Diagonal::anti:
          insert({a, b, e}, parent.faces[0]);
          insert({b, d, e}, parent.faces[1]);
          break;
      }
    }
  }
}

void copy_cell_data(vtkCellData* from, vtkCellData* to, const std::vector<vtkIdType>& parents) {
  if (from->GetNumberOfArrays() == 0) return;
  to->CopyGlobalIdsOff();
  to->CopyAllocate(from, static_cast<vtkIdType>(parents.size()));
  for (std::size_t i = 0; i < parents.size(); ++i)
    to->CopyData(from, parents[i], static_cast<vtkIdType>(i));
  keep_hidden_cells_only(to);
}

}  // namespace

bool refine_polygons(vtkPolyData* input, vtkPolyData* output, const Settings& settings, int levels,
                     bool limit, PointRule rule, vtkAlgorithm* filter) {
  check_kinds(input);
  const std::vector<Point3> positions = positions_of(input);
  std::vector<RefinedPatch> patches;
  vtkIdType points = 0;
  double rows = 0;
  for (const GridPatch& found :
       recover_grids(faces_of(input), static_cast<int>(positions.size()), positions)) {
    const GridPatch patch = oriented(found, positions);
    RefinedPatch& p =
        patches.emplace_back(RefinedPatch{patch,
                                          plan_axis(settings.x, patch.extent.cols, patch.wraps_cols,
                                                    settings.boundaries.x, levels, limit),
                                          plan_axis(settings.y, patch.extent.rows, patch.wraps_rows,
                                                    settings.boundaries.y, levels, limit),
                                          points});
    points += p.points();
    rows += static_cast<double>(p.y.output_count());
  }

  vtkPointData* from = input->GetPointData();
  const std::vector<vtkDataArray*> arrays = refinable_arrays(from);
  double components = 3;
  for (vtkDataArray* array : arrays) components += array->GetNumberOfComponents();
  Work work(filter, rows * components);

  vtkDataArray* coordinates = input->GetPoints()->GetData();
  const auto refined = refined_like(coordinates, points, refined_type(coordinates->GetDataType()));
  if (!refine_points(patches, coordinates, refined, PointRule::scheme, settings.threads, work))
    return false;
  const vtkNew<vtkPoints> result;
  result->SetData(refined);
  output->SetPoints(result);
  for (vtkDataArray* array : arrays) {
    const auto values = refined_like(array, points, refined_type(array->GetDataType()));
    if (!refine_points(patches, array, values, rule, settings.threads, work)) return false;
    add_like(from, array, output->GetPointData(), values);
  }

  const vtkNew<vtkCellArray> polygons;
  std::vector<vtkIdType> parents;
  for (const RefinedPatch& p : patches) append_polygons(p, polygons, parents);
  output->SetPolys(polygons);
  copy_cell_data(input->GetCellData(), output->GetCellData(), parents);
  return true;
}

}  // namespace arete::vtk_filters
