// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <vector>

#include "arete/vtk/image.h"

class vtkRenderer;

namespace arete::vtk {

/// Where a text stands relative to its place.
enum class TextPlace {
  right,         ///< begins there, its foot on it
  right_middle,  ///< begins there, centred on its height
  left_middle,   ///< ends there, centred on its height
  below,         ///< centred under it
  above_turned   ///< read upwards, centred on it
};

/// Fills a renderer with flat boxes and words, in pixels of the picture from its lower left corner;
/// `scale` drawn pixels stand for one.
class Painter {
 public:
  Painter(vtkRenderer& renderer, double scale, const Rgb& ink)
      : renderer_(renderer), scale_(scale), ink_(ink) {}

  /// Axis-parallel boxes {x0, y0, x1, y1}, one colour each.
  void boxes(const std::vector<std::array<double, 4>>& corners, const std::vector<Rgb>& colors);
  void text(const std::string& words, double x, double y, double size, TextPlace place);

 private:
  vtkRenderer& renderer_;
  double scale_;
  Rgb ink_;
};

}  // namespace arete::vtk
