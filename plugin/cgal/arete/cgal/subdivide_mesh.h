// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "arete/reverse/mesh_step.h"

namespace arete::cgal {

/// A mesh with positions, one vertex a row.
struct Mesh {
  MeshFaces faces;
  Grid<double> positions;
};

/// Any mesh subdivided by CGAL (Subdivision_method_3 on a Surface_mesh) in double: Catmull-Clark,
/// Loop (its own weights; boundary `smooth`) or Doo-Sabin (closed meshes). The oracle for reverse
/// subdivision. \throws InvalidField for other rules, or if CGAL refuses a face.
[[nodiscard]] Mesh subdivide(const Mesh& mesh, MeshRule rule, int levels);

}  // namespace arete::cgal
