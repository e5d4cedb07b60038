// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "arete/meshlab/subdivide.h"
#include "arete/reverse/axis_reverse.h"

namespace arete::meshlab {

struct CoarsenOptions {
  int levels = 1;
  ReverseMode mode = ReverseMode::least_squares;
  Boundary boundary = Boundary::extrapolate;  ///< of open rims; what wraps is periodic anyway
  Coordinates coordinates = Coordinates::heights;
};

struct Coarsened {
  CreatedMesh mesh;
  /// For every old vertex what the coarse mesh, refined again without details, misses there: the
  /// height (Coordinates::heights), or the distance (Coordinates::all). 0 at loose vertices.
  std::vector<float> details;
};

/// The mesh whose subdivision comes nearest to every grid of this one. What subdivided() made from
/// a mesh comes back as it was (one level of it, see docs/reverse.md for more), with details 0.
///
/// A coarse vertex lies where the scheme says, up to half a coarse cell beyond the rim for dual
/// schemes. In Coordinates::heights x and y are interpolated linearly there. Channels, wedges and
/// face attributes are taken over from the old mesh at its place; loose vertices are left behind.
///
/// \throws InvalidField for what surface_patches() refuses, boundary none or periodic, a grid too
/// small for that many levels, and a closed row or column whose vertices do not divide evenly;
/// InvalidScheme if the scheme has no reverse (see AxisReverse); Cancelled.
[[nodiscard]] Coarsened coarsened(const MeshArrays& mesh, const Scheme& scheme,
                                  const CoarsenOptions& options, Report& report);

}  // namespace arete::meshlab
