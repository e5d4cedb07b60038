// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "arete/topology/face_list.h"
#include "arete/topology/grid_patch.h"

namespace arete {

/// Turns a patch so that its rows and columns depend on where its vertices lie and not on how they
/// are numbered. A scheme that treats left and right differently needs this.
///
/// - Open grid: columns run as nearly along +x and rows along -y as one of the eight orientations
///   allows, so (0, 0) is north-west and rows and columns are those of a raster; ties (vertical
///   grids, grids turned by 45 degrees) are broken by the coordinates of the corners.
/// - Cylinder: columns go round, rows along; (0, 0) is the lexicographically smallest vertex of the
///   end whose smallest vertex is smaller, the next column the smaller of its two neighbours.
/// - Torus: (0, 0) is the smallest vertex, the next column the smallest of its four neighbours, the
///   next row the smaller one across.
/// Where vertices coincide the numbering may still show.
///
/// \pre a position for every vertex of the patch.
[[nodiscard]] GridPatch oriented(const GridPatch& patch, std::span<const Point3> positions);

}  // namespace arete
