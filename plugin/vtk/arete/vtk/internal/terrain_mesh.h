// SPDX-License-Identifier: MIT
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "arete/vtk/internal/sample_order.h"
#include "arete/vtk/internal/stage.h"

namespace arete::vtk {

/// The box a texture covers, in which the samples of a stage lie at `rows` and `cols`.
struct TextureBox {
  Extent extent{};
  AxisPlacement rows{};
  AxisPlacement cols{};
};

/// A surface as quads, with what it takes to draw or to export it.
struct TerrainMesh {
  /// Points (float, about the raster's centre, heights exaggerated), quads counter-clockwise seen
  /// from above, unit normals of the exaggerated surface, texture coordinates (v = 1 along the
  /// texture's first row).
  vtkSmartPointer<vtkPolyData> data;
  std::vector<Sample> samples;  ///< of each point

  [[nodiscard]] std::vector<Vector3> points() const;
};

/// \throws InvalidField when not a single quad is whole.
[[nodiscard]] TerrainMesh terrain_mesh(const Stage& stage, const TextureBox& box);

}  // namespace arete::vtk
