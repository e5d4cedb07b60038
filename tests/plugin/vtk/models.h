// SPDX-License-Identifier: MIT
#pragma once

#include <vtkCompositeDataIterator.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "arete/vtk/colormap.h"
#include "arete/vtk/internal/stage.h"
#include "pictures.h"

namespace arete::vtk {

/// A square with red in the north-west, green in the north-east, blue and white below.
inline Image four_colors(int side, std::uint8_t bright = 230) {
  Image image{side, side, {}};
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const bool west = 2 * x < side;
      const bool north = 2 * y < side;
      image.pixels.push_back(north  ? (west ? Rgb{bright, 0, 0} : Rgb{0, bright, 0})
                             : west ? Rgb{0, 0, bright}
                                    : Rgb{bright, bright, bright});
    }
  }
  return image;
}

/// The first mesh among the blocks, or null.
inline vtkSmartPointer<vtkPolyData> first_mesh(vtkMultiBlockDataSet* blocks) {
  vtkSmartPointer<vtkCompositeDataIterator> it;
  it.TakeReference(blocks->NewIterator());
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem()) {
    if (auto* mesh = vtkPolyData::SafeDownCast(it->GetCurrentDataObject())) return mesh;
  }
  return nullptr;
}

inline Vector3 point(vtkDataSet& data, vtkIdType id) {
  Vector3 at;
  data.GetPoint(id, at.data());
  return at;
}

}  // namespace arete::vtk
