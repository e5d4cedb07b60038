// SPDX-License-Identifier: MIT
#pragma once

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <algorithm>
#include <cstring>
#include <filesystem>

#include "arete/vtk/image.h"

namespace arete::vtk {

/// A PNG as VTK reads it; an empty image if it does not.
inline Image read_png(const std::filesystem::path& path) {
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.string().c_str());
  reader->Update();
  vtkImageData* data = reader->GetOutput();
  if (data->GetNumberOfPoints() == 0 || data->GetNumberOfScalarComponents() != 3) return {};
  Image image{data->GetDimensions()[0], data->GetDimensions()[1], {}};
  image.pixels.resize(static_cast<std::size_t>(image.width) *
                      static_cast<std::size_t>(image.height));
  for (int y = 0; y < image.height; ++y) {
    std::memcpy(
        image.pixels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width),
        data->GetScalarPointer(0, image.height - 1 - y, 0),
        static_cast<std::size_t>(image.width) * 3);
  }
  return image;
}

inline double luma(const Rgb& color) {
  return 0.299 * color[0] + 0.587 * color[1] + 0.114 * color[2];
}

/// A rectangle of pixels: columns x0 to x1 and rows y0 to y1, the last ones included.
struct Box {
  int x0 = 0;
  int y0 = 0;
  int x1 = -1;
  int y1 = -1;

  [[nodiscard]] int width() const { return x1 - x0 + 1; }
  [[nodiscard]] int height() const { return y1 - y0 + 1; }
};

/// The smallest box around the pixels for which `counts` holds.
template <class Counts>
Box box_of(const Image& image, Counts counts) {
  Box box{image.width, image.height, -1, -1};
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (!counts(image(x, y))) continue;
      box = {std::min(box.x0, x), std::min(box.y0, y), std::max(box.x1, x), std::max(box.y1, y)};
    }
  }
  return box;
}

inline double mean_luma(const Image& image, const Box& box) {
  double sum = 0;
  for (int y = box.y0; y <= box.y1; ++y) {
    for (int x = box.x0; x <= box.x1; ++x) sum += luma(image(x, y));
  }
  return sum / (box.width() * box.height());
}

}  // namespace arete::vtk
