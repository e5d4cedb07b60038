// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <filesystem>
#include <string>

#include "arete/vtk/appearance.h"
#include "arete/vtk/surface.h"

namespace arete::vtk {

/// How a surface becomes a textured model.
struct ModelOptions {
  Appearance appearance{};
  double exaggeration = 1;    ///< positive
  Index most_samples = 2000;  ///< a side; more are averaged
  std::string name = "terrain";
};

struct ModelReport {
  Index vertices = 0;
  Index quads = 0;
  Index reduction = 1;  ///< samples averaged into one, along each side
  Extent written{};     ///< samples after that
  int texture_width = 0;
  int texture_height = 0;
  /// What has to be added to a point of the model (x east, y north, z up, before exaggeration) to
  /// have the world's coordinates: points are kept about the middle, for single precision.
  std::array<double, 3> origin{};
  double lowest = 0;  ///< ends of the colours
  double highest = 0;
};

/// Writes a binary glTF 2.0 (.glb): one mesh of triangles with positions, unit normals and texture
/// coordinates, and one material (rough, not metallic, both sides) whose texture lies in the file
/// as a PNG. Without a texture of its own, the surface is given one in the colours of palette or
/// colormap, a pixel a sample, unlit. Every quad is cut along its shorter diagonal.
///
/// Lengths are those of the surface's plane (see surface.h), for glTF metres, with y up and -z
/// north. The node's extras hold "origin" (see ModelReport; x, y, z with z up), "crs" (WKT),
/// "exaggeration" and the notes.
/// \throws InvalidField see check_geometry; also when not a single quad is whole.
/// \throws RenderError see check(Appearance); for an exaggeration that is not positive.
/// \throws WriteError also for more than a .glb can hold (4 GiB).
ModelReport write_glb(const Surface& surface, const ModelOptions& options,
                      const std::filesystem::path& path);

/// The three files of an OBJ model, and how the first two name the others: without folder or
/// blanks.
struct ObjFiles {
  std::filesystem::path obj;
  std::filesystem::path mtl;
  std::filesystem::path texture;  ///< PNG
  std::string mtl_name;
  std::string texture_name;
};

/// Writes the same model as a Wavefront OBJ with its material and its texture: quads stay quads,
/// z is up. The origin is a comment. \throws as write_glb does.
ModelReport write_obj(const Surface& surface, const ModelOptions& options, const ObjFiles& files);

}  // namespace arete::vtk
