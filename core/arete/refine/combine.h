// SPDX-License-Identifier: MIT
#pragma once

#include "arete/refine/kernel/kernel.h"

namespace arete {

/// A vertical filter: out[c] = weights[0] lines[0][c] + weights[1] lines[1][c] + ... for c < count,
/// by the best kernel of this machine; the same bits on all (see Kernels).
template <class T>
void combine(T* out, const T* const* lines, const T* weights, int taps, Index count) {
  kernels<T>().combine(out, lines, weights, taps, count);
}

}  // namespace arete
