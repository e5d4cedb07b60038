// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
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

/// One number of every vertex (a colour component, quality, u, v, ...). New vertices get the
/// blend of the corners of the cell they lie in, or, where blending makes no sense (the number of
/// a texture), the number of the nearest corner.
struct Channel {
  std::vector<float> values;
  bool nearest = false;
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

/// New places for the vertices of a mesh; nothing else changes.
struct MovedMesh {
  std::vector<Point3> positions;
  std::vector<Point3> normals;  ///< of length 1; empty: to be computed from the faces
};

}  // namespace arete::meshlab
