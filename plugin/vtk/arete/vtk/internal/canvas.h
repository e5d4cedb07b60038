// SPDX-License-Identifier: MIT
#pragma once

#include "arete/vtk/image.h"
#include "arete/vtk/offscreen_window.h"

namespace arete::vtk {

/// A window drawn larger than the picture and averaged down: smooth edges at any driver.
class Canvas {
 public:
  /// \throws RenderError for a size outside 16 .. 8192, or without OpenGL.
  Canvas(int width, int height, int supersampling);

  [[nodiscard]] vtkRenderWindow& window() const { return window_.window(); }
  [[nodiscard]] const std::string& platform() const { return window_.platform(); }
  /// Drawn pixels per pixel of the picture, along each side.
  [[nodiscard]] int supersampling() const { return supersampling_; }
  /// Renders and reads back. \throws RenderError when the driver gives nothing.
  [[nodiscard]] Image draw();

 private:
  int supersampling_;
  OffscreenWindow window_;
};

}  // namespace arete::vtk
