// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "arete/topology/face_list.h"
#include "arete/vtk/surface.h"
#include "arete/vtk/write_options.h"

namespace arete::vtk {

/// A polygon mesh, borrowed. Attributes have one entry a vertex, or none at all.
struct PolygonMesh {
  std::span<const Point3> points;
  const FaceList& faces;
  std::span<const std::array<float, 3>> normals{};
  std::span<const std::array<std::uint8_t, 4>> colors{};  ///< red, green, blue, opacity
  std::span<const std::array<float, 2>> texcoords{};
  std::vector<Note> notes{};
};

/// Writes a mesh as a VTK polygon mesh (.vtp): faces as they are, points in double; "Normals",
/// "RGBA" and "TextureCoordinates" as point data; the notes as field data. Ids are 32 bits wide.
/// \throws InvalidField if there is no face, a face names a vertex that is not there, or an
/// attribute has another number of entries than there are vertices. \throws WriteError
void write_mesh(const PolygonMesh& mesh, const std::filesystem::path& path,
                const WriteOptions& options = {});

}  // namespace arete::vtk
