// SPDX-License-Identifier: MIT
#pragma once

#include "arete/reverse/mesh_step.h"

namespace arete::opensubdiv {

/// A mesh with positions, one vertex a row.
struct Mesh {
  MeshFaces faces;
  Grid<double> positions;
};

/// Any mesh refined uniformly by OpenSubdiv in double: Catmull-Clark or Loop (Loop's own weights),
/// with the rim `smooth` (VTX_BOUNDARY_EDGE_ONLY) or `sharp_corners` (EDGE_AND_CORNER). The oracle
/// for reverse subdivision. \throws InvalidField for other rules, or if OpenSubdiv refuses the
/// mesh.
[[nodiscard]] Mesh subdivide(const Mesh& mesh, MeshRule rule, int levels);

}  // namespace arete::opensubdiv
