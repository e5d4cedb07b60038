// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "arete/field/grid.h"

namespace arete {

/// One phase of a horizontal filter: sample t of a line v is turned into the sum of
/// weights[j] v[offset + t + j], j < taps, taken from left to right.
template <class T>
struct Strand {
  Index offset = 0;
  const T* weights = nullptr;
  int taps = 0;
};

/// A row before the horizontal filter: v[c] = weights[0] lines[0][c] + ... + weights[taps - 1]
/// lines[taps - 1][c], taken from left to right; for taps = 0 simply lines[0].
template <class T>
struct Warp {
  const T* const* lines = nullptr;
  const T* weights = nullptr;
  int taps = 0;
};

/// Samples that the kernels may read behind the last one a row is asked for; they take no part in
/// any result, but must be there and be numbers (zeros; stale memory holds denormals, which cost).
inline constexpr Index kernel_slack = 32;

/// A row of a level, filtered vertically, then horizontally, with every phase in its place: sample
/// arity t + i of `out` is strand i of the warp at t. Writes `count` samples and nothing else;
/// reads up to kernel_slack samples behind the last one it needs of every line. With `stream` (for
/// results larger than the cache; `out` must then be aligned to 64 bytes) whole cache lines go past
/// the cache.
template <class T>
using Weave = void (*)(T* out, const Warp<T>& warp, const Strand<T>* strands, int arity,
                       Index count, bool stream);

/// The inner loops of the engine for one instruction set. Every sum is taken from left to right and
/// nothing is contracted to fused operations, so all sets give the same bits as the plain
/// references below.
template <class T>
struct Kernels {
  /// A vertical filter: out[c] = weights[0] lines[0][c] + weights[1] lines[1][c] + ... for
  /// c < count; 0 for no taps. Writes nothing else. `out` must not overlap the lines.
  void (*combine)(T* out, const T* const* lines, const T* weights, int taps, Index count);

  /// The fastest Weave for warps of so many taps and these strands; its result depends on the taps
  /// and offsets alone, and holds for every offset that is shifted with all others. Null if there
  /// is none for such a warp; there is always one for 0 taps (see shapes).
  Weave<T> (*weave_for)(int warp_taps, const Strand<T>* strands, int arity);

  /// Whether all samples are finite.
  bool (*all_finite)(const T* samples, Index count);

  /// Makes streamed stores visible to other threads.
  void (*fence)();

  std::string_view name;
};

/// The instruction sets built into this library, the plainest first; the ones that this machine
/// cannot run are left out.
template <class T>
[[nodiscard]] const std::vector<const Kernels<T>*>& available_kernels();

/// The best of them, or the one that the environment variable ARETE_KERNEL names (for measurements
/// that must not depend on the machine; a name that is not available is ignored).
template <class T>
[[nodiscard]] const Kernels<T>& kernels();

template <class T>
void combine_reference(T* out, const T* const* lines, const T* weights, int taps, Index count) {
  for (Index c = 0; c < count; ++c) {
    T sum = taps > 0 ? weights[0] * lines[0][c] : T(0);
    for (int i = 1; i < taps; ++i) sum = sum + weights[i] * lines[i][c];
    out[c] = sum;
  }
}

template <class T>
void weave_reference(T* out, const T* line, const Strand<T>* strands, int arity, Index count) {
  for (Index k = 0; k < count; ++k) {
    const Strand<T>& strand = strands[k % arity];
    const T* from = line + strand.offset + k / arity;
    T sum = strand.taps > 0 ? strand.weights[0] * from[0] : T(0);
    for (int j = 1; j < strand.taps; ++j) sum = sum + strand.weights[j] * from[j];
    out[k] = sum;
  }
}

}  // namespace arete
