// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "arete/field/grid.h"

namespace arete::opensubdiv {

/// OpenSubdiv's rule at the rim of an open mesh (Sdc::Options::VtxBoundaryInterpolation). The two
/// differ in nothing but the neighbourhood of the four corners.
enum class CornerRule {
  sharp,  ///< VTX_BOUNDARY_EDGE_AND_CORNER: a corner stays where it is
  smooth  ///< VTX_BOUNDARY_EDGE_ONLY: the rim is one closed cubic B-spline, corners are rounded off
};

/// Catmull-Clark subdivision by OpenSubdiv (scheme Catmark, uniform, in double): the oracle for
/// `b-spline:degree=3`.
///
/// The samples of every plane are values at the vertices of the same rows x cols quad grid (a
/// height field is one plane, a surface in space three). The result has 2^levels (n - 1) + 1
/// samples per axis in row-major order, however OpenSubdiv numbers its vertices: each is put where
/// its bilinearly interpolated (row, col) says.
///
/// With `sharp` this equals refine() with Boundary::extrapolate on the whole grid; with `smooth` on
/// all samples whose stencils do not reach a corner (see tests/oracle).
///
/// Cost: about 150 bytes a new vertex, most of it topology.
/// \throws InvalidField if there is no plane, planes differ in size, an axis has fewer than two
/// samples, levels is not in 0..10, or the vertices exceed OpenSubdiv's 32-bit numbering.
[[nodiscard]] std::vector<Grid<double>> catmull_clark(
    const std::vector<GridView<const double>>& planes, int levels, CornerRule corners);

/// One plane.
[[nodiscard]] Grid<double> catmull_clark(const Grid<double>& heights, int levels,
                                         CornerRule corners);

}  // namespace arete::opensubdiv
