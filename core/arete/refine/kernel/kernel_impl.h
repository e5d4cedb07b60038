// SPDX-License-Identifier: MIT
// The inner loops, compiled once for each instruction set with ARETE_KERNEL_BYTES = bytes of a
// vector and ARETE_KERNEL_TABLE = name of the table. All of it has internal linkage and calls
// nothing inline from elsewhere: a copy compiled for a newer machine must not be the one that the
// linker keeps for all.
#include <utility>

#include "arete/refine/kernel/kernel.h"
#include "arete/refine/kernel/shape.h"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace arete {
namespace {

template <class T>
struct Vector {
  static constexpr int lanes = ARETE_KERNEL_BYTES / sizeof(T);
  typedef T Type __attribute__((vector_size(ARETE_KERNEL_BYTES)));
  typedef T Unaligned
      __attribute__((vector_size(ARETE_KERNEL_BYTES), aligned(alignof(T)), may_alias));

  [[gnu::always_inline]] static inline Type load(const T* from) {
    return *reinterpret_cast<const Unaligned*>(from);
  }
  [[gnu::always_inline]] static inline void store(T* to, Type v) {
    *reinterpret_cast<Unaligned*>(to) = v;
  }
  [[gnu::always_inline]] static inline Type all(T value) { return value - Type{}; }

  [[gnu::always_inline]] static inline void stream(T* to, Type v) {
#if defined(__AVX512F__) && ARETE_KERNEL_BYTES == 64
    _mm512_stream_si512(reinterpret_cast<__m512i*>(to), reinterpret_cast<__m512i>(v));
#elif defined(__AVX__) && ARETE_KERNEL_BYTES == 32
    _mm256_stream_si256(reinterpret_cast<__m256i*>(to), reinterpret_cast<__m256i>(v));
#elif defined(__SSE2__) && ARETE_KERNEL_BYTES == 16
    _mm_stream_si128(reinterpret_cast<__m128i*>(to), reinterpret_cast<__m128i>(v));
#else
    store(to, v);
#endif
  }
};

template <class T>
using V = Vector<T>;
template <class T>
using Vec = typename Vector<T>::Type;

// A fixed number of taps lets the compiler keep sum and weights in registers; 0 stands for any.
template <class T, int Taps, class Line>
[[gnu::always_inline]] inline Vec<T> sum_of(const T* weights, int taps, Line&& line) {
  if constexpr (Taps > 0) {
    Vec<T> sum = V<T>::all(weights[0]) * line(0);
#pragma GCC unroll 8
    for (int j = 1; j < Taps; ++j) sum = sum + V<T>::all(weights[j]) * line(j);
    return sum;
  } else {
    if (taps == 0) return Vec<T>{};
    Vec<T> sum = V<T>::all(weights[0]) * line(0);
    for (int j = 1; j < taps; ++j) sum = sum + V<T>::all(weights[j]) * line(j);
    return sum;
  }
}

template <class T, int Taps>
void combine_fixed(T* __restrict out, const T* const* lines, const T* weights, int taps,
                   Index count) {
  constexpr int lanes = V<T>::lanes;
  Index c = 0;
  for (; c + lanes <= count; c += lanes)
    V<T>::store(out + c, sum_of<T, Taps>(
                             weights, taps, [&](int j) __attribute__((always_inline)) {
                               return V<T>::load(lines[j] + c);
                             }));
  for (; c < count; ++c) {
    T sum = taps > 0 ? weights[0] * lines[0][c] : T(0);
    for (int j = 1; j < taps; ++j) sum = sum + weights[j] * lines[j][c];
    out[c] = sum;
  }
}

constexpr int most_taps = 64;

template <class T, int Taps>
void combine_with(T* out, const T* const* lines, const T* weights, int taps, Index count) {
  // Copies that cannot alias `out`, so that they stay in registers.
  const T* line[Taps > 0 ? Taps : most_taps];
  T weight[Taps > 0 ? Taps : 1];
  if constexpr (Taps == 0) {
    for (int j = 0; j < taps && j < most_taps; ++j) line[j] = lines[j];
    combine_fixed<T, 0>(out, line, weights, taps < most_taps ? taps : most_taps, count);
    for (int j = most_taps; j < taps; ++j)
      for (Index c = 0; c < count; ++c) out[c] = out[c] + weights[j] * lines[j][c];
  } else {
    for (int j = 0; j < Taps; ++j) {
      line[j] = lines[j];
      weight[j] = weights[j];
    }
    combine_fixed<T, Taps>(out, line, weight, Taps, count);
  }
}

template <class T>
void combine(T* out, const T* const* lines, const T* weights, int taps, Index count) {
  switch (taps) {
    case 1:
      return combine_with<T, 1>(out, lines, weights, taps, count);
    case 2:
      return combine_with<T, 2>(out, lines, weights, taps, count);
    case 3:
      return combine_with<T, 3>(out, lines, weights, taps, count);
    case 4:
      return combine_with<T, 4>(out, lines, weights, taps, count);
    case 5:
      return combine_with<T, 5>(out, lines, weights, taps, count);
    case 6:
      return combine_with<T, 6>(out, lines, weights, taps, count);
    case 7:
      return combine_with<T, 7>(out, lines, weights, taps, count);
    case 8:
      return combine_with<T, 8>(out, lines, weights, taps, count);
    default:
      return combine_with<T, 0>(out, lines, weights, taps, count);
  }
}

// Element i of the result is element Order::at(i) of the two vectors one after the other.
template <class T, class Order, std::size_t... I>
[[gnu::always_inline]] inline Vec<T> picked(Vec<T> a, Vec<T> b, std::index_sequence<I...>) {
  return __builtin_shufflevector(a, b, Order::at(static_cast<int>(I), V<T>::lanes)...);
}
template <class T, class Order>
[[gnu::always_inline]] inline Vec<T> pick(Vec<T> a, Vec<T> b) {
  return picked<T, Order>(a, b, std::make_index_sequence<static_cast<std::size_t>(V<T>::lanes)>{});
}

// Output vector K of two streams woven.
template <int K>
struct OfTwo {
  static constexpr int at(int i, int lanes) {
    const int n = K * lanes + i;
    return n / 2 + (n % 2) * lanes;
  }
};
// Output vector K of three: first the two of a and b, with gaps, then c into the gaps.
template <int K>
struct OfThreeFirst {
  static constexpr int at(int i, int lanes) {
    const int n = K * lanes + i;
    return n % 3 == 2 ? 0 : n / 3 + (n % 3) * lanes;
  }
};
template <int K>
struct OfThreeLast {
  static constexpr int at(int i, int lanes) {
    const int n = K * lanes + i;
    return n % 3 == 2 ? lanes + n / 3 : i;
  }
};

template <class T>
[[gnu::always_inline]] inline void weave_two(Vec<T> a, Vec<T> b, Vec<T>* out) {
  out[0] = pick<T, OfTwo<0>>(a, b);
  out[1] = pick<T, OfTwo<1>>(a, b);
}

template <class T>
[[gnu::always_inline]] inline void weave_three(Vec<T> a, Vec<T> b, Vec<T> c, Vec<T>* out) {
  out[0] = pick<T, OfThreeLast<0>>(pick<T, OfThreeFirst<0>>(a, b), c);
  out[1] = pick<T, OfThreeLast<1>>(pick<T, OfThreeFirst<1>>(a, b), c);
  out[2] = pick<T, OfThreeLast<2>>(pick<T, OfThreeFirst<2>>(a, b), c);
}

template <class T, int Arity>
[[gnu::always_inline]] inline void weave_vectors(const Vec<T>* in, Vec<T>* out) {
  if constexpr (Arity == 1) {
    out[0] = in[0];
  } else if constexpr (Arity == 2) {
    weave_two<T>(in[0], in[1], out);
  } else if constexpr (Arity == 3) {
    weave_three<T>(in[0], in[1], in[2], out);
  } else if constexpr (Arity == 4) {
    // 0 2 and 1 3 woven, then those two.
    Vec<T> even[2], odd[2];
    weave_two<T>(in[0], in[2], even);
    weave_two<T>(in[1], in[3], odd);
    weave_two<T>(even[0], odd[0], out);
    weave_two<T>(even[1], odd[1], out + 2);
  } else {
    static_assert(Arity == 9);
    Vec<T> third[3][3];
    for (int i = 0; i < 3; ++i) weave_three<T>(in[i], in[i + 3], in[i + 6], third[i]);
    for (int k = 0; k < 3; ++k) weave_three<T>(third[0][k], third[1][k], third[2][k], out + 3 * k);
  }
}

// A block is one vector of turns: `block(woven)` makes its Arity vectors; blocks come in order.
template <class T, int Arity, class Block>
[[gnu::always_inline]] inline void weave_blocks(T* out, Index count, bool stream, Block&& block) {
  constexpr int lanes = V<T>::lanes;
  constexpr Index whole = Arity * lanes;
  if (stream) {
    for (; count >= whole; count -= whole, out += whole) {
      Vec<T> woven[Arity];
      block(woven);
#pragma GCC unroll 9
      for (int k = 0; k < Arity; ++k) V<T>::stream(out + k * lanes, woven[k]);
    }
  } else {
    for (; count >= whole; count -= whole, out += whole) {
      Vec<T> woven[Arity];
      block(woven);
#pragma GCC unroll 9
      for (int k = 0; k < Arity; ++k) V<T>::store(out + k * lanes, woven[k]);
    }
  }
  if (count > 0) {
    Vec<T> woven[Arity];
    block(woven);
    int k = 0;
    // Full vectors go the same way: an ordinary store would wait for its line to be read.
    for (; stream && count >= lanes; ++k, count -= lanes) V<T>::stream(out + k * lanes, woven[k]);
    __builtin_memcpy(out + k * lanes, woven + k, static_cast<std::size_t>(count) * sizeof(T));
  }
}

// Elements Shift, Shift + 1, ... of two vectors one after the other.
template <int Shift>
struct Shifted {
  static constexpr int at(int i, int) { return Shift + i; }
};

// Whether lines are shifted in registers, which saves little where vectors seldom lie across two
// cache lines (measured: 10-40 % slower for 16 and 32 bytes, 30-40 % faster for 64).
constexpr bool shifts_in_registers = ARETE_KERNEL_BYTES == 64;

// Sample t + Place of a line whose vectors from t on are held.
template <class T, std::size_t Place>
[[gnu::always_inline]] inline Vec<T> window_at(const Vec<T>* held) {
  constexpr std::size_t lanes = static_cast<std::size_t>(V<T>::lanes);
  constexpr int shift = static_cast<int>(Place % lanes);
  if constexpr (shift == 0)
    return held[Place / lanes];
  else
    return pick<T, Shifted<shift>>(held[Place / lanes], held[Place / lanes + 1]);
}
template <class T, std::size_t Place>
[[gnu::always_inline]] inline Vec<T> window_at(const T* line) {
  return V<T>::load(line + Place);
}

template <class T, std::size_t... Later>
[[gnu::always_inline]] inline Vec<T> sum_in(const Vec<T>* window, const Vec<T>* weights,
                                            std::index_sequence<Later...>) {
  Vec<T> sum = weights[0] * window[0];
  ((sum = sum + weights[Later + 1] * window[Later + 1]), ...);
  return sum;
}

// `line` is one of what window_at takes.
template <class T, std::size_t Number, class Line, std::size_t... Phase, std::size_t... Place>
[[gnu::always_inline]] inline void weave_window(const Line* line,
                                                const Vec<T> (*weights)[shapes[Number].window()],
                                                Vec<T>* woven, std::index_sequence<Phase...>,
                                                std::index_sequence<Place...>) {
  const Vec<T> window[] = {window_at<T, Place>(line)...};
  const Vec<T> sums[] = {sum_in<T>(window + shapes[Number].first[Phase], weights[Phase],
                                   std::make_index_sequence<shapes[Number].taps[Phase] - 1>{})...};
  weave_vectors<T, shapes[Number].arity>(sums, woven);
}

// Strands of a known shape. What several of them read is loaded once, and where shifts are cheap,
// all is done in registers: whatever reads memory that has just been written may wait for the
// streamed stores before it, and vectors that lie across two cache lines cost two loads.
template <class T, std::size_t Number, int WarpTaps>
void weave_shape(T* __restrict out, const Warp<T>& warp, const Strand<T>* strands, int, Index count,
                 bool stream) {
  constexpr const Shape& shape = shapes[Number];
  constexpr auto arity = static_cast<std::size_t>(shape.arity);
  constexpr auto window = static_cast<std::size_t>(shape.window());
  constexpr auto lanes = static_cast<std::size_t>(V<T>::lanes);
  constexpr std::size_t held_size = (window - 1 + lanes - 1) / lanes + 1;
  constexpr int lines = WarpTaps > 0 ? WarpTaps : 1;
  constexpr std::make_index_sequence<arity> phases{};
  constexpr std::make_index_sequence<window> places{};

  const T* line[lines];
  Vec<T> line_weights[lines];
  for (int j = 0; j < lines; ++j) {
    line[j] = warp.lines[j] + strands[0].offset - shape.first[0];
    line_weights[j] = V<T>::all(WarpTaps > 0 ? warp.weights[j] : T(1));
  }
  Vec<T> weights[arity][window];
  for (std::size_t i = 0; i < arity; ++i)
    for (std::size_t j = 0; j < static_cast<std::size_t>(shape.taps[i]); ++j)
      weights[i][j] = V<T>::all(strands[i].weights[j]);

  Index at = 0;
  if constexpr (!shifts_in_registers) {
    static_assert(WarpTaps == 0);
    weave_blocks<T, shape.arity>(
        out, count, stream, [&](Vec<T> * woven) __attribute__((always_inline)) {
          weave_window<T, Number>(line[0] + at, weights, woven, phases, places);
          at += V<T>::lanes;
        });
  } else {
    const auto next = [&]() __attribute__((always_inline)) {
      Vec<T> sum = V<T>::load(line[0] + at);
      if constexpr (WarpTaps > 0) sum = line_weights[0] * sum;
#pragma GCC unroll 8
      for (int j = 1; j < lines; ++j) sum = sum + line_weights[j] * V<T>::load(line[j] + at);
      at += V<T>::lanes;
      return sum;
    };
    Vec<T> held[held_size];
    for (std::size_t k = 0; k + 1 < held_size; ++k) held[k] = next();
    weave_blocks<T, shape.arity>(
        out, count, stream, [&](Vec<T> * woven) __attribute__((always_inline)) {
          held[held_size - 1] = next();
          weave_window<T, Number>(held, weights, woven, phases, places);
          for (std::size_t k = 0; k + 1 < held_size; ++k) held[k] = held[k + 1];
        });
  }
}

template <class T, int Taps>
[[gnu::always_inline]] inline Vec<T> strand_sum(const T* line, const Strand<T>& strand) {
  return sum_of<T, Taps>(
      strand.weights,
      strand.taps, [&](int j) __attribute__((always_inline)) { return V<T>::load(line + j); });
}

template <class T>
[[gnu::always_inline]] inline Vec<T> strand_sum_of_any(const T* line, const Strand<T>& strand) {
  line += strand.offset;
  switch (strand.taps) {
    case 1:
      return strand_sum<T, 1>(line, strand);
    case 2:
      return strand_sum<T, 2>(line, strand);
    case 3:
      return strand_sum<T, 3>(line, strand);
    case 4:
      return strand_sum<T, 4>(line, strand);
    case 5:
      return strand_sum<T, 5>(line, strand);
    case 6:
      return strand_sum<T, 6>(line, strand);
    default:
      return strand_sum<T, 0>(line, strand);
  }
}

template <class T, int Arity>
void weave_some(T* __restrict out, const Warp<T>& warp, const Strand<T>* strands, int, Index count,
                bool stream) {
  const T* line = warp.lines[0];
  weave_blocks<T, Arity>(
      out, count, stream, [&](Vec<T> * woven) __attribute__((always_inline)) {
        Vec<T> phases[Arity];
#pragma GCC unroll 9
        for (int i = 0; i < Arity; ++i) phases[i] = strand_sum_of_any<T>(line, strands[i]);
        weave_vectors<T, Arity>(phases, woven);
        line += V<T>::lanes;
      });
}

template <class T>
void weave_any(T* __restrict out, const Warp<T>& warp, const Strand<T>* strands, int arity,
               Index count, bool) {
  constexpr int lanes = V<T>::lanes;
  for (int i = 0; i < arity; ++i) {
    for (Index t = 0; arity * t + i < count; t += lanes) {
      const Vec<T> sum = strand_sum_of_any<T>(warp.lines[0] + t, strands[i]);
      for (Index k = 0; k < lanes && arity * (t + k) + i < count; ++k)
        out[arity * (t + k) + i] = sum[k];
    }
  }
}

template <class T>
bool has_shape(const Strand<T>* strands, int arity, const Shape& shape) {
  if (arity != shape.arity) return false;
  for (int i = 0; i < arity; ++i) {
    const auto n = static_cast<std::size_t>(i);
    if (strands[i].taps != shape.taps[n] ||
        strands[i].offset - strands[0].offset != shape.first[n] - shape.first[0])
      return false;
  }
  return true;
}

// Warps are of the same scheme as the strands, mostly, and so of the taps of one of them.
template <class T, std::size_t Number, std::size_t... Phase>
Weave<T> weave_of_shape(int warp_taps, std::index_sequence<Phase...>) {
  Weave<T> found = warp_taps == 0 ? weave_shape<T, Number, 0> : nullptr;
  if constexpr (shifts_in_registers)
    (void)((warp_taps == shapes[Number].taps[Phase]
                ? (found = weave_shape<T, Number, shapes[Number].taps[Phase]>, true)
                : false) ||
           ...);
  return found;
}

template <class T, std::size_t... Number>
Weave<T> weave_of_shapes(int warp_taps, const Strand<T>* strands, int arity,
                         std::index_sequence<Number...>) {
  Weave<T> found = nullptr;
  (void)((has_shape(strands, arity, shapes[Number])
              ? (found = weave_of_shape<T, Number>(
                     warp_taps, std::make_index_sequence<shapes[Number].arity>{}),
                 true)
              : false) ||
         ...);
  return found;
}

template <class T>
Weave<T> weave_for(int warp_taps, const Strand<T>* strands, int arity) {
  if (const Weave<T> found = weave_of_shapes(
          warp_taps, strands, arity, std::make_index_sequence<sizeof(shapes) / sizeof(Shape)>{}))
    return found;
  if (warp_taps > 0) return nullptr;
  switch (arity) {
    case 1:
      return weave_some<T, 1>;
    case 2:
      return weave_some<T, 2>;
    case 3:
      return weave_some<T, 3>;
    case 4:
      return weave_some<T, 4>;
    case 9:
      return weave_some<T, 9>;
    default:
      return weave_any<T>;
  }
}

template <class T>
bool all_finite(const T* samples, Index count) {
  constexpr int lanes = V<T>::lanes;
  // x - x is 0 for every finite x, and NaN otherwise; a sum keeps a NaN.
  Vec<T> sum{};
  Index c = 0;
  for (; c + lanes <= count; c += lanes) {
    const Vec<T> v = V<T>::load(samples + c);
    sum = sum + (v - v);
  }
  T rest = 0;
  for (; c < count; ++c) rest = rest + (samples[c] - samples[c]);
  for (int i = 0; i < lanes; ++i) rest = rest + sum[i];
  return rest == 0;
}

inline void fence() {
#if defined(__SSE2__)
  _mm_sfence();
#endif
}

}  // namespace
}  // namespace arete
