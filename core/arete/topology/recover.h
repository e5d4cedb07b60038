// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "arete/topology/face_list.h"
#include "arete/topology/grid_patch.h"
#include "arete/topology/not_a_grid.h"

namespace arete {

/// Finds the rows and columns of meshes that are regular grids, by topology alone: vertices, faces
/// and corners may come in any order and lie anywhere in space.
///
/// Each connected component becomes one patch, in the order of their lowest faces:
/// - quads: an open grid, a cylinder (one axis wraps) or a torus (both wrap);
/// - triangles: an open grid every cell of which is cut along either diagonal.
/// Vertices without faces belong to no patch.
///
/// Which of its orientations a patch comes in depends on the numbering; oriented() makes it
/// definite.
///
/// Triangulations can be ambiguous. A corner vertex with one face settles it (a grid with equal
/// diagonals has two such corners). Without one - 9 of 4000 random triangulations up to 9 x 9 admit
/// a second grid - the grid with the shortest edges is taken, if `positions` are given.
///
/// \throws NotAGrid for anything else, naming the first offending vertex or face: a hole, an
/// L-shape, a vertex with another number of faces than 4 (2 at the rim, 1 at a corner), two patches
/// that touch in one vertex, triangles mixed with quads, a torus whose columns close with an
/// offset, triangulated cylinders and tori, and all that HalfEdges refuses.
///
/// Time and memory are linear in the number of corners (for triangles: usually).
[[nodiscard]] std::vector<GridPatch> recover_grids(const FaceList& faces, int vertex_count,
                                                   std::span<const Point3> positions = {});

}  // namespace arete
