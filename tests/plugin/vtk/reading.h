// SPDX-License-Identifier: MIT
#pragma once

#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <filesystem>
#include <string>

namespace arete::vtk {

/// What VTK's own reader makes of a file.
template <class Reader>
auto read_back(const std::filesystem::path& path) {
  auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(path.string().c_str());
  reader->Update();
  using Output = std::remove_pointer_t<decltype(reader->GetOutput())>;
  return vtkSmartPointer<Output>(reader->GetOutput());
}

inline double value(vtkDataSet& data, const char* array, vtkIdType point) {
  return data.GetPointData()->GetArray(array)->GetTuple1(point);
}

/// The text of that name in the field data, or "(none)".
inline std::string field_text(vtkDataSet& data, const char* name) {
  auto* array = vtkStringArray::SafeDownCast(data.GetFieldData()->GetAbstractArray(name));
  return array == nullptr || array->GetNumberOfValues() != 1 ? "(none)"
                                                             : std::string(array->GetValue(0));
}

/// The ghost flags, or none.
inline vtkUnsignedCharArray* ghosts(vtkDataSet& data) {
  return vtkUnsignedCharArray::SafeDownCast(data.GetPointData()->GetArray("vtkGhostType"));
}

}  // namespace arete::vtk
