// SPDX-License-Identifier: MIT
#include "cli/cardinal_stencil.h"

#include "arete/analysis/certificate.h"
#include "arete/fractal/arc_matrices.h"
#include "cli/error.h"

namespace arete::cli {

Stencil cardinal_stencil(const Scheme& scheme) {
  const Mask& mask = scheme.mask();
  if (certify(mask, 8).order < 0)
    throw Misuse("--interpolate: " + scheme.text() +
                 " has no certified limit; choose a convergent scheme");
  // New samples lie tau/(m-1) before the classical parameter of theirs.
  auto stencil = limit_stencil_at(mask, mask.tau() / (mask.arity() - 1));
  if (!stencil)
    throw Misuse("--interpolate: the limit of " + scheme.text() +
                 " at its samples (tau = " + to_string(mask.tau()) +
                 ") has no weights that can be computed; choose parameters with a simpler tau");
  return *std::move(stencil);
}

}  // namespace arete::cli
