// SPDX-License-Identifier: MIT
#pragma once

#include <vtkNew.h>
#include <vtkRenderer.h>

#include <vector>

#include "arete/vtk/internal/canvas.h"
#include "arete/vtk/internal/reduce.h"
#include "arete/vtk/internal/stage.h"
#include "arete/vtk/render.h"

namespace arete::vtk {

/// A surface set up to be drawn as options say, but for the camera. Borrows both.
class Scene {
 public:
  /// \throws as render() does.
  Scene(const Surface& surface, const RenderOptions& options);

  /// Each sets the camera and draws.
  [[nodiscard]] Image draw_oblique();
  [[nodiscard]] Image draw_map();
  [[nodiscard]] Image draw_from(double azimuth, double radius);
  /// How far draw_from has to stand for the terrain to fit from all of these.
  [[nodiscard]] double radius(std::span<const double> azimuths) const;

  [[nodiscard]] RenderReport report() const;

 private:
  void add_terrain();
  void add_walls();
  [[nodiscard]] Image draw(double legend_left);
  [[nodiscard]] double beside_terrain();

  const RenderOptions& options_;
  Extent original_;
  ReducedSurface reduced_;
  std::array<double, 2> heights_;
  std::array<double, 2> range_;
  double exaggeration_;
  Stage stage_;
  Canvas canvas_;
  vtkNew<vtkRenderer> backdrop_;
  vtkNew<vtkRenderer> scene_;
  vtkNew<vtkRenderer> legend_;
  double split_ = 1;  ///< share of the width that the terrain has
  double aspect_ = 1;
  std::vector<Vector3> points_;
};

}  // namespace arete::vtk
