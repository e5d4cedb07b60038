// SPDX-License-Identifier: MIT
#include "internal/point_data.h"

#include <cmath>

#include "internal/bilinear.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkUnsignedCharArray.h"

namespace arete::vtk_filters {
namespace {

void normalise(vtkDataArray* normals) {
  for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i) {
    double n[3];
    normals->GetTuple(i, n);
    const double length = std::hypot(n[0], n[1], n[2]);
    if (length > 0) normals->SetTuple3(i, n[0] / length, n[1] / length, n[2] / length);
  }
}

}  // namespace

PointRefiner::PointRefiner(const StructuredPiece& piece, const HeldInput& held, int threads)
    : piece_(piece),
      held_(held),
      single_(piece.window().x.plan, piece.window().y.plan, threads),
      double_(piece.window().x.plan, piece.window().y.plan, threads) {}

Index PointRefiner::points() const {
  return piece_.rows().count() * piece_.cols().count() * count_along(piece_.part(), 2);
}

double PointRefiner::steps(vtkDataArray* array) const {
  return static_cast<double>(piece_.rows().count()) *
         static_cast<double>(count_along(piece_.part(), 2)) *
         (array ? array->GetNumberOfComponents() : 1);
}

template <class T>
bool PointRefiner::refine_as(vtkDataArray* array, vtkDataArray* result, PointRule rule,
                             Work& work) const {
  const VtkExtent& part = piece_.part();
  const Index slice = piece_.rows().count() * piece_.cols().count();
  std::vector<Between> rows, cols;
  if (rule == PointRule::linear) {
    const StructuredPlan& plan = piece_.plan();
    rows = within(sample_places(plan.y, piece_.rows()), piece_.window().y.samples, plan.y);
    cols = within(sample_places(plan.x, piece_.cols()), piece_.window().x.samples, plan.x);
  }
  T* data = static_cast<T*>(result->GetVoidPointer(0));
  const int step = array->GetNumberOfComponents();
  for (int k = part[4]; k <= part[5]; ++k) {
    for (int component = 0; component < step; ++component) {
      const Grid<T> plane = read_plane<T>(array, component, k, piece_, held_);
      const Index first = slice * (k - part[4]);
      if (rule == PointRule::scheme) {
        bool finished = false;
        if constexpr (std::is_same_v<T, float>)
          finished = refine_plane(single_, plane, result, component, first, work);
        else
          finished = refine_plane(double_, plane, result, component, first, work);
        if (!finished) return false;
        continue;
      }
      T* out = data + first * step + component;
      for (const Between& y : rows) {
        for (const Between& x : cols) {
          *out = bilinear(plane, y, x);
          out += step;
        }
        if (!work.done(1)) return false;
      }
    }
  }
  return true;
}

bool PointRefiner::refine(vtkDataArray* array, vtkDataArray* result, PointRule rule,
                          Work& work) const {
  return result->GetDataType() == VTK_FLOAT ? refine_as<float>(array, result, rule, work)
                                            : refine_as<double>(array, result, rule, work);
}

bool PointRefiner::mark_hidden(vtkUnsignedCharArray* result, Work& work) const {
  const VtkExtent& part = piece_.part();
  const Index slice = piece_.rows().count() * piece_.cols().count();
  for (int k = part[4]; k <= part[5]; ++k) {
    const Grid<float> plane = read_plane<float>(nullptr, 0, k, piece_, held_);
    unsigned char* flags = result->GetPointer(slice * (k - part[4]));
    const bool finished =
        refine_in_bands<float>(single_, plane, work, [&](Index first, GridView<const float> band) {
          for (Index r = 0; r < band.rows(); ++r)
            for (Index c = 0; c < band.cols(); ++c)
              flags[(first + r) * band.cols() + c] =
                  std::isnan(band(r, c)) ? vtkDataSetAttributes::HIDDENPOINT : 0;
        });
    if (!finished) return false;
  }
  return true;
}

std::vector<vtkDataArray*> refinable_arrays(vtkDataSetAttributes* data) {
  std::vector<vtkDataArray*> arrays;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i) {
    vtkDataArray* array = data->GetArray(i);
    if (!array || array == data->GetGlobalIds() || array == data->GetPedigreeIds()) continue;
    const char* name = array->GetName();
    if (name && std::string(name) == vtkDataSetAttributes::GhostArrayName()) continue;
    arrays.push_back(array);
  }
  return arrays;
}

vtkSmartPointer<vtkDataArray> refined_like(vtkDataArray* array, Index tuples, int type) {
  auto result = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  result->SetName(array->GetName());
  result->SetNumberOfComponents(array->GetNumberOfComponents());
  result->CopyComponentNames(array);
  result->SetNumberOfTuples(tuples);
  return result;
}

void add_like(vtkDataSetAttributes* in, vtkDataArray* array, vtkDataSetAttributes* out,
              vtkDataArray* result) {
  const int index = out->AddArray(result);
  for (int role = 0; role < vtkDataSetAttributes::NUM_ATTRIBUTES; ++role) {
    if (in->GetAbstractAttribute(role) != array) continue;
    if (role == vtkDataSetAttributes::NORMALS) normalise(result);
    out->SetActiveAttribute(index, role);
  }
}

}  // namespace arete::vtk_filters
