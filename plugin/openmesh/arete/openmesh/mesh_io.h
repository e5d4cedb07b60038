// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "arete/field/boundary.h"
#include "arete/field/grid.h"
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
  std::vector<Point3> points{};
  FaceList faces{};
  std::vector<std::array<float, 3>> normals{};           ///< of vertices
  std::vector<std::array<std::uint8_t, 4>> colors{};     ///< of vertices: red, green, blue, opacity
  std::vector<std::array<float, 2>> texcoords{};         ///< of vertices
  std::vector<std::array<float, 2>> corner_texcoords{};  ///< of corners, beside faces.corners
};

/// Whether the file name ends in .obj, .ply, .off or .stl, in either case.
[[nodiscard]] bool is_mesh_file(const std::string& path);

/// Reads OBJ, PLY (text or binary), OFF (text) or STL, after the file's extension, in double:
/// OpenMesh's own readers go through float, which moves terrain in UTM coordinates by centimetres.
/// Quads stay quads. Texture coordinates are those of corners in OBJ and in PLY faces (`texcoord`,
/// as MeshLab writes them), otherwise those of vertices. A vertex has one normal: of several that
/// OBJ faces name, the last. STL has no shared vertices: equal positions become one.
/// \throws MeshFileError naming the file, for text the line, and the remedy.
[[nodiscard]] MeshData read_mesh(const std::string& path);

/// How a mesh is written.
struct MeshOutput {
  /// Such as "ply"; overrules the extension, so that a file may be written under another name.
  std::string format{};
  bool single_precision = false;  ///< positions as float
  /// Lines for the reader, in all formats but STL.
  std::vector<std::string> comments{};
  /// Told the share done, 0..1, from time to time; may throw to stop the work.
  std::function<void(double)> progress{};
};

/// Writes OBJ and OFF as text that reads back as the same numbers, PLY binary, STL binary as
/// triangles in float (the format has nothing else; no attributes). Corner texture coordinates that
/// are the same all around every vertex are written to OFF as those of vertices; with seams OFF
/// cannot hold them, see is_seamless(). Memory: that of the mesh and a small buffer.
/// \throws MeshFileError; the file is then incomplete and should be removed.
void write_mesh(const std::string& path, const MeshData& mesh, const MeshOutput& output = {});

/// Whether corner texture coordinates are the same all around every vertex (or absent).
[[nodiscard]] bool is_seamless(const MeshData& mesh);
/// Corner texture coordinates as those of vertices. \pre is_seamless(mesh).
[[nodiscard]] std::vector<std::array<float, 2>> vertex_texcoords(const MeshData& mesh);

/// How refine_mesh() refines.
struct MeshRefineOptions {
  int levels = 1;
  Boundaries boundaries{};
  int threads = 1;
  bool on_limit = false;  ///< see GridSubdividerT::set_on_limit
  bool normals = false;   ///< make normals even if the mesh has none
};

/// How large a refined mesh will be.
struct RefinedMeshSize {
  struct Patch {
    Extent coarse;
    Extent fine;
  };
  std::vector<Patch> patches;
  double vertices = 0;
  double faces = 0;
  double bytes = 0;  ///< of memory that refine_mesh() needs, about
};

/// \throws what refine_mesh() would, but nothing is computed.
[[nodiscard]] RefinedMeshSize refined_size(const MeshData& mesh, const Scheme& along_rows,
                                           const Scheme& along_cols,
                                           const MeshRefineOptions& options);

/// A mesh of grids refined: GridSubdividerT for plain arrays. x, y and z follow the schemes,
/// colours and texture coordinates are bilinear; normals, if the mesh has them, are made anew.
/// \throws NotAGrid, InvalidField as described there, and for a vertex that is not finite.
[[nodiscard]] MeshData refine_mesh(const MeshData& mesh, const Scheme& along_rows,
                                   const Scheme& along_cols, const MeshRefineOptions& options);

}  // namespace arete::openmesh
