// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "arete/field/grid.h"

namespace arete {

/// One phase of a horizontal filter: sample t is the sum of weights[j] line[t + j], j < taps, taken
/// from left to right.
template <class T>
struct Strand {
  const T* line = nullptr;
  const T* weights = nullptr;
  int taps = 0;
};

/// Samples that the kernels may read behind the last one a row is asked for; they take no part in
/// any result, but must be there and be numbers (zeros; stale memory holds denormals, which cost).
inline constexpr Index kernel_slack = 32;

/// The inner loops of the engine for one instruction set. Every sum is taken from left to right and
/// nothing is contracted to fused operations, so all sets give the same bits as the plain
/// references below.
template <class T>
struct Kernels {
  /// A vertical filter: out[c] = weights[0] lines[0][first + c] + weights[1] lines[1][first + c] +
  /// ... for c < count; 0 for no taps. Writes nothing else. `out` must not overlap the lines.
  void (*combine)(T* out, const T* const* lines, Index first, const T* weights, int taps,
                  Index count);

  /// A horizontal filter, every phase in its place: out[arity t + i] = strand i at t, for t < turns
  /// and i < arity.
  /// Reads up to kernel_slack samples behind every line. With `stream` (for results larger than the
  /// cache; `out` must then be aligned to 64 bytes) whole cache lines go past the cache.
  void (*weave)(T* out, const Strand<T>* strands, int arity, Index turns, bool stream);

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
void weave_reference(T* out, const Strand<T>* strands, int arity, Index turns) {
  for (Index t = 0; t < turns; ++t) {
    for (int i = 0; i < arity; ++i) {
      const Strand<T>& strand = strands[i];
      T sum = strand.taps > 0 ? strand.weights[0] * strand.line[t] : T(0);
      for (int j = 1; j < strand.taps; ++j) sum = sum + strand.weights[j] * strand.line[t + j];
      out[arity * t + i] = sum;
    }
  }
}

}  // namespace arete
