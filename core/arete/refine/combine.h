// SPDX-License-Identifier: MIT
#pragma once

#include "arete/field/grid.h"

namespace arete {

/// THE hot loop: out[c] = weights[0] lines[0][c] + weights[1] lines[1][c] + ... for c < count, the
/// sum taken from left to right. With lines of different rows it is the vertical stencil, with one
/// line at shifted starts the horizontal one. `out` must not overlap the lines.
/// No sum is ever split or reordered and nothing is contracted to fused operations, so the result
/// is the same to the last bit for any count, alignment and instruction set.
template <class T>
void combine(T* out, const T* const* lines, const T* weights, int taps, Index count);

/// The same in its plainest form, kept as the truth the fast one is tested against.
template <class T>
void combine_reference(T* out, const T* const* lines, const T* weights, int taps, Index count) {
  for (Index c = 0; c < count; ++c) {
    T sum = taps > 0 ? weights[0] * lines[0][c] : T(0);
    for (int i = 1; i < taps; ++i) sum = sum + weights[i] * lines[i][c];
    out[c] = sum;
  }
}

/// out[arity c + phase] = line[c] for c < count: puts the samples of one phase in their places.
template <class T>
void scatter(T* out, const T* line, int arity, Index count);

/// out[2c] = even[c], out[2c + 1] = odd[c] for c < count.
template <class T>
void interleave(T* out, const T* even, const T* odd, Index count);

}  // namespace arete
