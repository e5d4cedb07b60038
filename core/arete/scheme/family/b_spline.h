// SPDX-License-Identifier: MIT
#pragma once

#include "arete/algebra/fraction.h"

namespace arete::family {

/// The uniform B-spline of degree >= 1 (Lane and Riesenfeld 1980): 2^-degree (1+z)^(degree+1),
/// first index -floor((degree+1)/2). C^(degree-1). Degree 3 on a grid is regular Catmull-Clark.
template <class R>
[[nodiscard]] LaurentPolynomial<R> b_spline(int degree) {
  const LaurentPolynomial<R> half(0, {fraction<R>(1, 2)});
  return (power(smoothing_factor<R>(2), degree + 1) * power(half, degree))
      .shifted(-((degree + 1) / 2));
}

}  // namespace arete::family
