// SPDX-License-Identifier: MIT
#pragma once

#include "arete/scheme/scheme.h"
#include "arete/scheme/stencil.h"

namespace arete::cli {

/// What --interpolate needs of a scheme: the exact weights of its limit at the position of a sample
/// (variational/cardinal.h). \throws Misuse where the limit is not certified to exist, or where tau
/// is such that these weights cannot be had.
[[nodiscard]] Stencil cardinal_stencil(const Scheme& scheme);

}  // namespace arete::cli
