// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "arete/topology/face_list.h"

namespace arete::meshlab {

/// Three vertex numbers in order around the face.
using Triangle = std::array<int, 3>;

/// A texture coordinate of one corner of one face, and the number of the texture it belongs to.
struct WedgeUv {
  float u = 0;
  float v = 0;
  int texture = 0;

  [[nodiscard]] friend bool operator==(const WedgeUv&, const WedgeUv&) = default;
};

/// How a number of the vertices is carried over to a place between them, or a little beyond them.
enum class Blend {
  linear,  ///< beyond the outermost vertices it goes on as inside (texture coordinates)
  within,  ///< linear, but never beyond what the vertices around have (colour, quality)
  nearest  ///< the number of the nearest vertex (which texture)
};

/// One number of every vertex.
struct Channel {
  std::vector<float> values;
  Blend blend = Blend::within;
};

/// A MeshLab mesh as plain arrays, without deleted elements: the only thing an action sees.
struct MeshArrays {
  std::vector<Point3> positions;
  std::vector<Triangle> triangles;
  /// Bit k of entry f: edge k of triangle f, from its corner k to k+1, is inside a polygon
  /// (MeshLab's faux bits, which may be stale). Empty: the mesh is not polygonal.
  std::vector<std::uint8_t> inner_edges;
  std::vector<Channel> channels;
  std::vector<std::array<WedgeUv, 3>> wedges;  ///< per triangle; empty: there are none
};

/// What takes the place of a mesh. The vertices 0..old-1 are the vertices of that mesh under their
/// old numbers, the new ones follow; `triangles` holds all triangles anew.
struct RefinedMesh {
  MeshArrays arrays;
  std::vector<int> source_triangles;  ///< the old triangle in whose place each new one lies
  std::vector<int> dropped_vertices;  ///< old vertices that no triangle uses any more
};

/// A mesh to be put beside the one it was made from, with the same kinds of attributes. Its
/// channels may be left out as a whole.
struct CreatedMesh {
  std::string label;
  MeshArrays arrays;
  /// The old triangle whose colour, quality and selection each new one takes over; empty: none.
  std::vector<int> source_triangles;
};

/// New places for the vertices of a mesh; nothing else changes.
struct MovedMesh {
  std::vector<Point3> positions;
  std::vector<Point3> normals;  ///< of length 1; 0, or empty: to be computed from the faces
};

}  // namespace arete::meshlab
