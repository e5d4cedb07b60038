// SPDX-License-Identifier: MIT
#include "internal/surface_mesh.h"

#include <array>
#include <cmath>
#include <vector>

#include "internal/cell_data.h"
#include "internal/point_data.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

namespace arete::vtk_filters {
namespace {

// From sample indices and height to space.
class Frame {
 public:
  explicit Frame(const SurfaceForm& form) : form_(form) {
    form.image.GetOrigin(origin_);
    form.image.GetSpacing(spacing_);
    direction_ = form.image.GetDirectionMatrix()->GetData();
  }

  [[nodiscard]] std::array<double, 3> point(double i, double j, double height) const {
    std::array<double, 3> p =
        turned({i * spacing_[0], j * spacing_[1], form_.part[4] * spacing_[2] + height});
    for (std::size_t a = 0; a < 3; ++a) p[a] += origin_[a];
    return p;
  }
  // From derivatives by the index: the normal before it is turned, of length 1.
  [[nodiscard]] std::array<double, 3> local_normal(double by_i, double by_j) const {
    const double dx = by_i / spacing_[0];
    const double dy = by_j / spacing_[1];
    const double length = std::hypot(dx, dy, 1.0);
    return {-dx / length, -dy / length, 1 / length};
  }
  [[nodiscard]] std::array<double, 3> turned(const std::array<double, 3>& v) const {
    std::array<double, 3> result{};
    for (std::size_t row = 0; row < 3; ++row)
      for (std::size_t a = 0; a < 3; ++a) result[row] += direction_[3 * row + a] * v[a];
    return result;
  }
  // Whether i, j and the heights are left-handed, so that quads have to be turned round.
  [[nodiscard]] bool mirrored() const {
    const double* d = direction_;
    const double determinant = d[0] * (d[4] * d[8] - d[5] * d[7]) -
                               d[1] * (d[3] * d[8] - d[5] * d[6]) +
                               d[2] * (d[3] * d[7] - d[4] * d[6]);
    return spacing_[0] * spacing_[1] * determinant < 0;
  }

 private:
  const SurfaceForm& form_;
  double origin_[3];
  double spacing_[3];
  const double* direction_ = nullptr;
};

vtkSmartPointer<vtkFloatArray> float_array(const char* name, int components, vtkIdType tuples) {
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  return array;
}

vtkSmartPointer<vtkUnsignedCharArray> ghost_array(vtkIdType tuples) {
  auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
  array->SetName(vtkDataSetAttributes::GhostArrayName());
  array->SetNumberOfTuples(tuples);
  array->Fill(0);
  return array;
}

// Which quads and points there are, and the ids of the points.
struct Selection {
  std::vector<std::uint8_t> whole_quads;
  std::vector<vtkIdType> ids;  ///< -1: left out
  vtkIdType points = 0;
};

Selection select(const Grid<double>& height, bool keep_all) {
  const Index rows = height.rows();
  const Index cols = height.cols();
  Selection s;
  s.ids.assign(static_cast<std::size_t>(rows * cols), keep_all ? 0 : -1);
  s.whole_quads.assign(
      static_cast<std::size_t>(std::max<Index>(rows - 1, 0) * std::max<Index>(cols - 1, 0)), 0);
  const auto valid = [&](Index r, Index c) { return std::isfinite(height(r, c)); };
  for (Index r = 0; r + 1 < rows; ++r) {
    for (Index c = 0; c + 1 < cols; ++c) {
      if (!valid(r, c) || !valid(r, c + 1) || !valid(r + 1, c) || !valid(r + 1, c + 1)) continue;
      s.whole_quads[static_cast<std::size_t>(r * (cols - 1) + c)] = 1;
      for (const Index point : {r * cols + c, r * cols + c + 1})
        s.ids[static_cast<std::size_t>(point)] = s.ids[static_cast<std::size_t>(point + cols)] = 0;
    }
  }
  for (vtkIdType& id : s.ids)
    if (id == 0) id = s.points++;
  return s;
}

void add_points(const SurfaceForm& form, const SurfacePlanes& planes, const Frame& frame,
                const Selection& selection, vtkPolyData* output) {
  const Index cols = planes.height.cols();
  const vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(selection.points);
  const auto normals = float_array("Normals", 3, selection.points);
  const auto slopes = float_array("Slope", 1, selection.points);
  const auto texture = float_array("TextureCoordinates", 2, selection.points);
  const auto ghosts = ghost_array(selection.points);
  for (Index r = 0; r < planes.height.rows(); ++r) {
    for (Index c = 0; c < cols; ++c) {
      const vtkIdType id = selection.ids[static_cast<std::size_t>(r * cols + c)];
      if (id < 0) continue;
      const double h = planes.height(r, c);
      const bool valid = std::isfinite(h);
      const double i = form.part[0] + static_cast<double>(c) + form.first_x;
      const double j = form.part[2] + static_cast<double>(r) + form.first_y;
      points->SetPoint(id, frame.point(i, j, valid ? form.factor * h : 0).data());
      const double by_i = form.factor * planes.by_x(r, c);
      const double by_j = form.factor * planes.by_y(r, c);
      const bool level = !std::isfinite(by_i) || !std::isfinite(by_j);
      const auto local = frame.local_normal(level ? 0 : by_i, level ? 0 : by_j);
      const auto normal = frame.turned(local);
      normals->SetTuple(id, normal.data());
      slopes->SetValue(
          id, static_cast<float>(vtkMath::DegreesFromRadians(std::acos(std::min(1.0, local[2])))));
      const auto share = [](double position, int begin, Index count) {
        return static_cast<float>((position - begin + 0.5) / static_cast<double>(count));
      };
      texture->SetTuple2(id, share(i, form.whole[0], count_along(form.whole, 0)),
                         share(j, form.whole[2], count_along(form.whole, 1)));
      if (!valid) ghosts->SetValue(id, vtkDataSetAttributes::HIDDENPOINT);
    }
  }
  output->SetPoints(points);
  output->GetPointData()->SetNormals(normals);
  output->GetPointData()->SetTCoords(texture);
  output->GetPointData()->AddArray(slopes);
  if (form.blank) output->GetPointData()->AddArray(ghosts);
}

// The data of the image's points, and the heights of the surface in place of those of the image.
void pass_point_data(const SurfaceForm& form, const SurfacePlanes& planes,
                     const Selection& selection, vtkPolyData* output) {
  vtkPointData* from = form.image.GetPointData();
  vtkPointData* to = output->GetPointData();
  const VtkExtent e = [&] {
    VtkExtent extent;
    form.image.GetExtent(extent.data());
    return extent;
  }();
  const Index cols = planes.height.cols();
  const Index width = count_along(e, 0);
  for (vtkDataArray* array : refinable_arrays(from)) {
    if (to->HasArray(array->GetName())) continue;
    const bool is_height = array == form.heights;
    auto copy = vtkSmartPointer<vtkDataArray>::Take(is_height ? vtkDoubleArray::New()
                                                              : array->NewInstance());
    copy->SetName(array->GetName());
    copy->SetNumberOfComponents(array->GetNumberOfComponents());
    copy->CopyComponentNames(array);
    copy->SetNumberOfTuples(selection.points);
    for (Index r = 0; r < planes.height.rows(); ++r) {
      for (Index c = 0; c < cols; ++c) {
        const vtkIdType id = selection.ids[static_cast<std::size_t>(r * cols + c)];
        if (id < 0) continue;
        if (is_height)
          copy->SetComponent(id, 0, planes.height(r, c));
        else
          copy->SetTuple(id, (form.part[2] + r - e[2]) * width + form.part[0] + c - e[0], array);
      }
    }
    const int index = to->AddArray(copy);
    if (from->GetScalars() == array) to->SetActiveAttribute(index, vtkDataSetAttributes::SCALARS);
  }
}

void add_quads(const SurfaceForm& form, const SurfacePlanes& planes, const Frame& frame,
               const Selection& selection, vtkPolyData* output) {
  const Index rows = planes.height.rows();
  const Index cols = planes.height.cols();
  VtkExtent e;
  form.image.GetExtent(e.data());
  vtkCellData* from = form.image.GetCellData();
  vtkCellData* to = output->GetCellData();
  const bool pass = from->GetNumberOfArrays() > 0;
  if (pass) {
    to->CopyGlobalIdsOff();
    to->CopyAllocate(from);
  }
  const vtkNew<vtkCellArray> quads;
  const auto ghosts = ghost_array(0);
  const bool mirrored = frame.mirrored();
  for (Index r = 0; r + 1 < rows; ++r) {
    for (Index c = 0; c + 1 < cols; ++c) {
      const bool whole = selection.whole_quads[static_cast<std::size_t>(r * (cols - 1) + c)] != 0;
      if (!whole && !form.blank) continue;
      const auto id = [&](Index dr, Index dc) {
        return selection.ids[static_cast<std::size_t>((r + dr) * cols + c + dc)];
      };
      std::array<vtkIdType, 4> corners{id(0, 0), id(0, 1), id(1, 1), id(1, 0)};
      if (mirrored) std::swap(corners[1], corners[3]);
      const vtkIdType cell = quads->InsertNextCell(4, corners.data());
      ghosts->InsertNextValue(whole ? 0 : vtkDataSetAttributes::HIDDENCELL);
      if (pass)
        to->CopyData(from,
                     (form.part[2] + r - e[2]) * (count_along(e, 0) - 1) + form.part[0] + c - e[0],
                     cell);
    }
  }
  output->SetPolys(quads);
  keep_hidden_cells_only(to);
  if (!form.blank) return;
  if (auto* known =
          vtkUnsignedCharArray::SafeDownCast(to->GetArray(vtkDataSetAttributes::GhostArrayName())))
    for (vtkIdType i = 0; i < ghosts->GetNumberOfTuples(); ++i)
      ghosts->SetValue(i, ghosts->GetValue(i) | known->GetValue(i));
  to->AddArray(ghosts);
}

}  // namespace

void make_surface(const SurfaceForm& form, const SurfacePlanes& planes, vtkPolyData* output) {
  const Frame frame(form);
  const Selection selection = select(planes.height, form.blank);
  add_points(form, planes, frame, selection, output);
  pass_point_data(form, planes, selection, output);
  add_quads(form, planes, frame, selection, output);
}

}  // namespace arete::vtk_filters
