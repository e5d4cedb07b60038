// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "arete/variational/minimal_patch.h"

namespace arete {

/// The boundary of a four-sided patch from a closed loop of points: its corners are the points
/// `corners` (four increasing numbers), or where none are given, the points nearest to the quarters
/// of its length, starting from point 0. A side is the polygon between its corners by length, or
/// smooth: the natural spline through its points, uniform in their numbers.
/// \throws InvalidField for other corners, fewer than four points, or a loop of no length.
[[nodiscard]] PatchBoundary patch_boundary(const std::vector<Point3>& loop,
                                           const std::vector<int>& corners, bool smooth);

/// The boundary of a ring from two closed loops. The second is turned about and its beginning
/// shifted so that the loops lie as near to each other as can be. \throws InvalidField for fewer
/// than three points, or a loop of no length.
[[nodiscard]] PatchBoundary ring_boundary(const std::vector<Point3>& first,
                                          const std::vector<Point3>& second, bool smooth);

}  // namespace arete
