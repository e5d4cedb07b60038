// SPDX-License-Identifier: MIT
#pragma once

#include "arete/field/grid.h"

namespace arete {

/// Catmull-Clark on an open grid whose four corners are not held: OpenSubdiv's
/// VTX_BOUNDARY_EDGE_ONLY, and what CGAL does. It is `b-spline:degree=3` with Boundary::extrapolate
/// but for one rule: at every level a corner p with its neighbours a, b on the two rims becomes
/// (6 p + a + b) / 8, as on a smooth rim, where extrapolation keeps p. The difference is that of
/// the corner alone at level 1 and stays less than two input samples away from it.
///
/// Level by level and whole in memory: a reference to compare with, not a way to refine.
/// \throws InvalidField if an axis has fewer than two samples or levels < 0.
[[nodiscard]] Grid<double> refine_free_corners(const Grid<double>& heights, int levels);

}  // namespace arete
