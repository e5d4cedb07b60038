// SPDX-License-Identifier: MIT
#pragma once

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <vector>

#include "arete/vtk/image.h"

class vtkRenderer;

namespace arete::vtk {

/// A place in the drawn picture (after supersampling), from its lower left corner.
struct Pixel {
  double x = 0;
  double y = 0;
};

/// Filled shapes of one colour. Lines are drawn as polygons: OpenGL's core profile knows no widths.
class Shapes {
 public:
  /// Shapes of a higher layer (0 .. 8) lie on top.
  explicit Shapes(int layer) : layer_(layer) {}

  void disc(Pixel centre, double radius);
  void box(Pixel low, Pixel high);
  /// Round joins and ends.
  void line(const std::vector<Pixel>& points, bool closed, double width);
  /// Hands them to a renderer, whose camera set_pixel_camera has set or will set.
  void draw(const Rgb& color, vtkRenderer& renderer) const;

 private:
  void add(double x, double y);
  void segment(Pixel a, Pixel b, double width);

  int layer_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> cells_;
};

/// One unit is one drawn pixel, from the lower left corner.
void set_pixel_camera(int width, int height, vtkRenderer& renderer);

}  // namespace arete::vtk
