// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "arete/field/grid.h"

namespace arete::cgal {

/// Catmull-Clark subdivision of a height field by CGAL (CatmullClark_subdivision on a
/// Surface_mesh): a second oracle for `b-spline:degree=3`. CGAL rounds corners off like OpenSubdiv
/// with VTX_BOUNDARY_EDGE_ONLY.
///
/// Sample (r, c) becomes a vertex at (c, -r, height); the result has 2^levels (n - 1) + 1 samples
/// an axis. CGAL numbers new vertices as it likes, so rows and columns are found again by topology.
///
/// \throws InvalidField if an axis has fewer than two samples or levels is not in 0..10.
[[nodiscard]] Grid<double> catmull_clark(const Grid<double>& heights, int levels);

}  // namespace arete::cgal
