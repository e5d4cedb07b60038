// SPDX-License-Identifier: MIT
#pragma once

#include "arete/reverse/local_corner_cutting.h"
#include "arete/reverse/local_five_coefficients.h"
#include "arete/reverse/local_interpolatory.h"

namespace arete {

/// Which schemes have a reverse by short filters.
enum class LocalRule {
  none,
  interpolatory,     ///< any arity: four-point, dubuc-deslauriers, three-point, ternary-two-step-9,
                     ///< ...
  corner_cutting,    ///< four binary coefficients, u + v != 1: chaikin, de-rham, b-spline:degree=2
  five_coefficients  ///< five binary coefficients with two-point odd samples: b-spline:degree=3
};

[[nodiscard]] inline LocalRule local_rule(const Mask& mask) {
  if (local::interpolated_phase(mask)) return LocalRule::interpolatory;
  const std::size_t size = mask.coefficients().size();
  if (mask.arity() != 2) return LocalRule::none;
  if (size == 4 && mask[mask.first()] + mask[mask.last()] != 1) return LocalRule::corner_cutting;
  if (size == 5 && mask[mask.first() + 1] != 0 && mask[mask.first() + 3] != 0)
    return LocalRule::five_coefficients;
  return LocalRule::none;
}

/// The local reverse of a level. Nothing if the scheme has no local rule, or if the ends of an open
/// axis leave a coarse sample without its filter (shifts tau far from the middle of the mask).
template <class R>
[[nodiscard]] std::optional<LocalReverse<R>> local_reverse(const Mask& mask,
                                                           const ReverseLevel& level,
                                                           Boundary boundary) {
  const LocalRule rule = local_rule(mask);
  if (rule == LocalRule::none) return std::nullopt;
  const SparseRows<R> s = synthesis_rows<R>(mask, level, boundary);
  const local::Problem<R> problem{mask, level, boundary, s};
  if (level.coarse_count == 1 && (!level.closed || level.fine_count == 1))
    return local::single_sample(problem);
  switch (rule) {
    case LocalRule::interpolatory:
      return local::interpolatory(problem);
    case LocalRule::corner_cutting:
      return local::CornerCutting<R>(problem).build();
    default:
      return local::five_coefficients(problem);
  }
}

}  // namespace arete
