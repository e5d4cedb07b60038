// SPDX-License-Identifier: MIT
#include "arete/vtk/internal/canvas.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkWindowToImageFilter.h>

#include <cstring>

#include "arete/vtk/error.h"

namespace arete::vtk {
namespace {

int checked(int size) {
  if (size < 16 || size > 8192) {
    throw RenderError("a picture is 16 to 8192 pixels wide and high, not " + std::to_string(size));
  }
  return size;
}

/// Above this the usual largest viewport of 16384 would be exceeded.
int affordable(int width, int height, int supersampling) {
  while (supersampling > 1 && std::max(width, height) * supersampling > 16384) --supersampling;
  return supersampling;
}

}  // namespace

Canvas::Canvas(int width, int height, int supersampling)
    : supersampling_(affordable(checked(width), checked(height), supersampling)),
      window_(width * supersampling_, height * supersampling_) {}

Image Canvas::draw() {
  window().Render();
  vtkNew<vtkWindowToImageFilter> reader;
  reader->SetInput(&window());
  reader->SetInputBufferTypeToRGB();
  reader->ReadFrontBufferOff();
  reader->ShouldRerenderOff();
  reader->Update();
  vtkImageData* drawn = reader->GetOutput();
  Image image{drawn->GetDimensions()[0], drawn->GetDimensions()[1], {}};
  if (image.width < 1 || image.height < 1) throw RenderError("the OpenGL driver gave no picture");
  const auto width = static_cast<std::size_t>(image.width);
  image.pixels.resize(width * static_cast<std::size_t>(image.height));
  for (int y = 0; y < image.height; ++y) {  // VTK's first row is the lowest
    std::memcpy(image.pixels.data() + width * static_cast<std::size_t>(y),
                drawn->GetScalarPointer(0, image.height - 1 - y, 0), width * sizeof(Rgb));
  }
  return shrink(image, supersampling_);
}

}  // namespace arete::vtk
