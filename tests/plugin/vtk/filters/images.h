// SPDX-License-Identifier: MIT
#pragma once

#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <array>
#include <cstring>
#include <initializer_list>
#include <string>
#include <vector>

#include "arete/field/grid.h"

namespace arete::test {

/// A flat image of heights, row r of the grid at j = r; the array is called "height".
template <class Array = vtkDoubleArray, class T>
vtkSmartPointer<vtkImageData> image_of(const Grid<T>& heights, std::array<int, 2> begin = {0, 0}) {
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(begin[0], begin[0] + static_cast<int>(heights.cols()) - 1, begin[1],
                   begin[1] + static_cast<int>(heights.rows()) - 1, 0, 0);
  const vtkNew<Array> array;
  array->SetName("height");
  array->SetNumberOfTuples(static_cast<vtkIdType>(heights.samples().size()));
  for (std::size_t i = 0; i < heights.samples().size(); ++i)
    array->SetComponent(static_cast<vtkIdType>(i), 0, static_cast<double>(heights.samples()[i]));
  image->GetPointData()->SetScalars(array);
  return image;
}

/// A component of a point array of a flat image, row by row.
inline Grid<double> grid_of(vtkImageData* image, const char* name = "height", int component = 0) {
  const int* size = image->GetDimensions();
  Grid<double> grid({size[1], size[0]});
  vtkDataArray* array = image->GetPointData()->GetArray(name);
  for (std::size_t i = 0; i < grid.samples().size(); ++i)
    grid.samples()[i] = array->GetComponent(static_cast<vtkIdType>(i), component);
  return grid;
}

/// Hides points of an image.
inline void hide(vtkImageData* image, std::initializer_list<vtkIdType> points) {
  const vtkNew<vtkUnsignedCharArray> flags;
  flags->SetName(vtkDataSetAttributes::GhostArrayName());
  flags->SetNumberOfTuples(image->GetNumberOfPoints());
  flags->Fill(0);
  for (const vtkIdType point : points) flags->SetValue(point, vtkDataSetAttributes::HIDDENPOINT);
  image->GetPointData()->AddArray(flags);
}

inline bool same_bits(const Grid<double>& a, const Grid<double>& b) {
  return a.extent() == b.extent() &&
         std::memcmp(a.samples().data(), b.samples().data(), a.samples().size() * 8) == 0;
}

/// Collects the errors of what it watches (instead of their being printed).
class Errors : public vtkCommand {
 public:
  static Errors* New() { return new Errors; }
  void watch(vtkObject* watched) { watched->AddObserver(vtkCommand::ErrorEvent, this); }
  void Execute(vtkObject*, unsigned long, void* text) override {
    messages.emplace_back(static_cast<const char*>(text));
  }
  [[nodiscard]] bool mention(const std::string& text) const {
    for (const std::string& message : messages)
      if (message.find(text) != std::string::npos) return true;
    return false;
  }
  std::vector<std::string> messages;
};

}  // namespace arete::test
