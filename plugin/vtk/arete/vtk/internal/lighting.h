// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "arete/vtk/internal/terrain_mesh.h"
#include "arete/vtk/light.h"

class vtkProperty;
class vtkRenderer;

namespace arete::vtk {

/// The lights of a picture: those asked for, and a faint bluish one from opposite the first that
/// keeps slopes in the shade legible and casts no shadow.
class Lighting {
 public:
  Lighting(std::vector<Light> lights, const Material& material, bool shadows);

  void set(vtkRenderer& renderer) const;
  /// \param flat no highlights: a map is seen from straight above everywhere, and no part of it may
  /// shine more than another.
  void set(vtkProperty& property, bool flat) const;

  /// What the colour at each point of the mesh is to be multiplied with, by channel, so that the
  /// driver's lighting, which knows no shadows, comes out with them; and darker where little of the
  /// sky is seen.
  [[nodiscard]] std::vector<std::array<float, 3>> dimming(const Stage& stage,
                                                          const TerrainMesh& mesh) const;

 private:
  std::vector<Light> lights_;  ///< the last one is the faint one
  Material material_;
  bool shadows_;
};

}  // namespace arete::vtk
