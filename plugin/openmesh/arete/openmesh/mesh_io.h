// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "arete/field/boundary.h"
#include "arete/scheme/scheme.h"
#include "arete/topology/face_list.h"

namespace arete::openmesh {

/// A file that cannot be read or written as a mesh; the message names it and says what to do.
class MeshFileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A mesh as it stands in a file: plain arrays, faces of any number of corners, nothing repaired
/// and nothing dropped. Attributes are empty or complete.
struct MeshData {
  std::vector<Point3> points;
  FaceList faces;
  std::vector<std::array<std::uint8_t, 4>> colors;     ///< of vertices: red, green, blue, opacity
  std::vector<std::array<float, 2>> texcoords;         ///< of vertices
  std::vector<std::array<float, 2>> corner_texcoords;  ///< of corners, beside faces.corners
};

/// Whether the file name ends in .obj, .ply, .off or .stl, in either case.
[[nodiscard]] bool is_mesh_file(const std::string& path);

/// Reads OBJ, PLY (text or binary), OFF (text) or STL, after the file's extension, in double:
/// OpenMesh's own readers go through float, which moves terrain in UTM coordinates by centimetres.
/// Quads stay quads. OBJ texture coordinates are those of corners, PLY and OFF ones those of
/// vertices. STL has no shared vertices: equal positions become one. Normals are not read, for
/// refinement makes its own. \throws MeshFileError naming the file, for text the line, and the
/// remedy.
[[nodiscard]] MeshData read_mesh(const std::string& path);

/// Writes OBJ and OFF as text that reads back as the same numbers, PLY binary in double, STL binary
/// as triangles in float (the format has nothing else). Corner texture coordinates are written to
/// OBJ only. `format`, such as "ply", overrules the extension, so that a file may be written under
/// another name first. \throws MeshFileError
void write_mesh(const std::string& path, const MeshData& mesh, const std::string& format = "");

/// How refine_mesh() refines.
struct MeshRefineOptions {
  int levels = 1;
  Boundaries boundaries;
  int threads = 1;
};

/// A mesh of grids refined: GridSubdividerT for plain arrays. x, y and z follow the schemes,
/// colours and texture coordinates are bilinear. \throws NotAGrid, InvalidField as described there.
[[nodiscard]] MeshData refine_mesh(const MeshData& mesh, const Scheme& along_rows,
                                   const Scheme& along_cols, const MeshRefineOptions& options);

}  // namespace arete::openmesh
