// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "arete/topology/face_list.h"
#include "arete/topology/grid_patch.h"

namespace arete {

/// A height field as the vertices of a mesh: sample (r, c) is vertex r cols + c, at (c, -r,
/// height). Its quads, looking up, are grid_faces(extent, true).
[[nodiscard]] std::vector<Point3> height_points(const Grid<double>& heights);

/// The way back from a mesh that is one grid over such a plane, however its vertices are numbered:
/// rows and columns are found by topology and turned by place. \throws NotAGrid; InvalidField for
/// no grid or several.
[[nodiscard]] Grid<double> heights_of(const FaceList& faces, const std::vector<Point3>& points);

}  // namespace arete
