// SPDX-License-Identifier: MIT
#pragma once

#include "arete/field/boundary.h"
#include "arete/field/georeference.h"
#include "arete/refine/level_rule.h"
#include "arete/scheme/mask.h"

namespace arete {

/// One reverse step along one axis, as far as sizes and places go: which fine samples there are and
/// how many coarse ones stand for them.
///
/// With arity m and parametric shift tau, the scheme's sample k lies at (k - tau)/m among the
/// coarse samples 0..n-1.
///
/// - Open axis: n is the largest count whose refined nodes (the k with 0 <= (k - tau)/m <= n - 1,
///   what `refine` makes with one level) are not more than the fine samples. Up to m - 1 fine
///   samples are left over; they lie beyond the nodes, shared between the ends, and are predicted
///   from ghost samples as the boundary says. Primal schemes: n = ceil(N/m); Chaikin: n =
///   floor(N/2) + 1, so 2n - 2 -> n. Coarse and details are exactly N numbers.
/// - Closed axis: n = ceil(N/m), so 1074, 537, 269, 135, 68, 34, 17. Up to m - 1 samples that lie
///   evenly on the segment from the last to the first are appended first (for m = 2 the midpoint)
///   and dropped after reconstruction; coarse and details are then N + padding numbers.
/// - One sample stays one sample.
struct ReverseLevel {
  Index fine_count = 0;
  Index coarse_count = 0;
  Index padding = 0;  ///< closed axes only
  IndexRange rows;    ///< the scheme's indices of the fine samples, padding included
  bool closed = false;
  int arity = 2;
  Rational tau;

  /// \throws InvalidField for fine_count < 1 or boundary `none` (its ghosts would be unknowns).
  ReverseLevel(const Mask& mask, Index count, Boundary boundary);

  /// How many details stand beside the coarse samples.
  [[nodiscard]] Index detail_count() const { return rows.count() - coarse_count; }
  /// Coarse sample j lies at first + j spacing among the fine samples.
  [[nodiscard]] AxisPlacement placement() const;
};

/// The place of samples that lie at `inner` among samples that themselves lie at `outer`.
[[nodiscard]] AxisPlacement composed(const AxisPlacement& outer, const AxisPlacement& inner);

}  // namespace arete
