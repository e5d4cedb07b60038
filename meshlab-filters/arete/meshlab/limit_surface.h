// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "arete/meshlab/subdivide.h"

namespace arete::meshlab {

/// Moves every vertex of the mesh's grids to its place on the limit surface of the scheme, and
/// gives it the normal there: the cross product of the exact partial derivatives, on the side that
/// the faces look to.
///
/// Normals are left out (and the log says so) where the scheme is not certified C^1. In
/// Coordinates::heights x and y stay, except for schemes whose limits cannot be had at the old
/// places: there the vertices move along by that part of a cell, which the log tells.
/// options.levels is not read.
///
/// \throws InvalidScheme if the scheme is not certified to have limits; InvalidField as
/// subdivided(), and for boundary none, which leaves the rim without limits.
[[nodiscard]] MovedMesh moved_to_limit(const MeshArrays& mesh, const Scheme& scheme,
                                       const SubdivideOptions& options, Report& report);

}  // namespace arete::meshlab
