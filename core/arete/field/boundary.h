// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "arete/field/grid.h"

namespace arete {

/// How an axis is continued beyond its ends. It happens once, at level 0, by as many ghost samples
/// as the stencils reach; after that only the interior rule runs.
///
/// With samples p_0..p_{n-1} and k >= 1:
enum class Boundary {
  extrapolate,  ///< p_{-k} = p_0 + k (p_0 - p_1): planes stay planes. For the cubic B-spline this
                ///< is Catmull-Clark with OpenSubdiv's VTX_BOUNDARY_EDGE_AND_CORNER, exactly.
  clamp,     ///< p_{-k} = p_0
  reflect,   ///< p_{-k} = p_k (the end sample is not repeated)
  periodic,  ///< p_{-k} = p_{n-k}: the axis is closed, n samples a turn
  none       ///< no ghosts: only new samples whose whole stencil exists; the domain shrinks
};

/// The rule along each axis.
struct Boundaries {
  Boundary x = Boundary::extrapolate;  ///< along a row, from column to column
  Boundary y = Boundary::extrapolate;  ///< from row to row

  [[nodiscard]] friend bool operator==(const Boundaries&, const Boundaries&) = default;
};

/// Reads `clamp`. \throws InvalidField listing the names for any other text.
[[nodiscard]] Boundary parse_boundary(std::string_view text);
/// Reads `clamp` (both axes) or `periodic,clamp` (x, then y).
[[nodiscard]] Boundaries parse_boundaries(std::string_view text);
[[nodiscard]] std::string_view to_string(Boundary boundary);

/// A sample of a continued axis as one or two real samples: p_near + steps (p_near - p_far).
/// steps is 0 unless the boundary extrapolates.
struct Continuation {
  Index near = 0;
  Index far = 0;
  Index steps = 0;
};

/// Where sample `index` of an axis with `count` >= 1 real samples comes from; inside it is itself.
/// One sample alone is continued as a constant by every rule. \pre boundary is not `none` when the
/// index lies outside.
[[nodiscard]] Continuation continued(Boundary boundary, Index index, Index count);

}  // namespace arete
