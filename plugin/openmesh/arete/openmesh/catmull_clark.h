// SPDX-License-Identifier: MIT
#pragma once

#include "arete/field/grid.h"

namespace arete::openmesh {

/// Catmull-Clark subdivision of a height field by OpenMesh's own CatmullClarkT: an oracle for
/// `b-spline:degree=3` inside, and only there. At the rim OpenMesh 9 takes (V + m1 + m2) / 3 of a
/// vertex and the midpoints of its two rim edges, the mask [1, 3, 4, 3, 1] / 6, where Catmull-Clark
/// and the cubic B-spline have [1, 4, 6, 4, 1] / 8. What depends on the rim within `levels` levels
/// lies less than two input samples away from it.
///
/// Sample (r, c) becomes a vertex at (c, -r, height); the result has 2^levels (n - 1) + 1 samples
/// an axis, rows and columns found again by topology.
///
/// \throws InvalidField if an axis has fewer than two samples or levels is not in 0..10.
[[nodiscard]] Grid<double> catmull_clark(const Grid<double>& heights, int levels);

}  // namespace arete::openmesh
