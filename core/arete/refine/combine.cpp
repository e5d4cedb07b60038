// SPDX-License-Identifier: MIT
#include "arete/refine/combine.h"

#include <algorithm>
#include <utility>

namespace arete {
namespace {

// A fixed number of taps lets the compiler keep the whole sum in registers.
template <class T, int Taps>
void combine_fixed(T* __restrict out, const T* const* lines, const T* weights, Index count) {
  const T* line[Taps];
  T weight[Taps];
  for (int i = 0; i < Taps; ++i) {
    line[i] = lines[i];
    weight[i] = weights[i];
  }
  for (Index c = 0; c < count; ++c) {
    T sum = weight[0] * line[0][c];
    for (int i = 1; i < Taps; ++i) sum = sum + weight[i] * line[i][c];
    out[c] = sum;
  }
}

template <class T>
void add_line(T* __restrict out, const T* __restrict line, T weight, Index count) {
  for (Index c = 0; c < count; ++c) out[c] = out[c] + weight * line[c];
}

constexpr int largest_fixed = 8;

template <class T, int... Taps>
void combine_dispatched(T* out, const T* const* lines, const T* weights, int taps, Index count,
                        std::integer_sequence<int, Taps...>) {
  ((taps == Taps + 1 ? combine_fixed<T, Taps + 1>(out, lines, weights, count) : void()), ...);
}

}  // namespace

template <class T>
void combine(T* out, const T* const* lines, const T* weights, int taps, Index count) {
  if (taps == 0) {
    std::fill_n(out, count, T(0));
    return;
  }
  const int fixed = std::min(taps, largest_fixed);
  combine_dispatched(out, lines, weights, fixed, count,
                     std::make_integer_sequence<int, largest_fixed>{});
  for (int i = fixed; i < taps; ++i) add_line(out, lines[i], weights[i], count);
}

template <class T>
void scatter(T* out, const T* line, int arity, Index count) {
  for (Index c = 0; c < count; ++c) out[c * arity] = line[c];
}

template <class T>
void interleave(T* __restrict out, const T* __restrict even, const T* __restrict odd, Index count) {
  for (Index c = 0; c < count; ++c) {
    out[2 * c] = even[c];
    out[2 * c + 1] = odd[c];
  }
}

template void combine(float*, const float* const*, const float*, int, Index);
template void combine(double*, const double* const*, const double*, int, Index);
template void scatter(float*, const float*, int, Index);
template void scatter(double*, const double*, int, Index);
template void interleave(float*, const float*, const float*, Index);
template void interleave(double*, const double*, const double*, Index);

}  // namespace arete
