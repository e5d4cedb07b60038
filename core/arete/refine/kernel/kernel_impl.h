// SPDX-License-Identifier: MIT
// The inner loops, compiled once for each instruction set with ARETE_KERNEL_BYTES = bytes of a
// vector and ARETE_KERNEL_TABLE = name of the table. All of it has internal linkage and calls
// nothing inline from elsewhere: a copy compiled for a newer machine must not be the one that the
// linker keeps for all.
#include <utility>

#include "arete/refine/kernel/kernel.h"

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
void combine_with(T* out, const T* const* lines, Index first, const T* weights, int taps,
                  Index count) {
  // Copies that cannot alias `out`, so that they stay in registers.
  const T* line[Taps > 0 ? Taps : most_taps];
  T weight[Taps > 0 ? Taps : 1];
  if constexpr (Taps == 0) {
    for (int j = 0; j < taps && j < most_taps; ++j) line[j] = lines[j] + first;
    combine_fixed<T, 0>(out, line, weights, taps < most_taps ? taps : most_taps, count);
    for (int j = most_taps; j < taps; ++j)
      for (Index c = 0; c < count; ++c) out[c] = out[c] + weights[j] * lines[j][first + c];
  } else {
    for (int j = 0; j < Taps; ++j) {
      line[j] = lines[j] + first;
      weight[j] = weights[j];
    }
    combine_fixed<T, Taps>(out, line, weight, Taps, count);
  }
}

template <class T>
void combine(T* out, const T* const* lines, Index first, const T* weights, int taps, Index count) {
  switch (taps) {
    case 1:
      return combine_with<T, 1>(out, lines, first, weights, taps, count);
    case 2:
      return combine_with<T, 2>(out, lines, first, weights, taps, count);
    case 3:
      return combine_with<T, 3>(out, lines, first, weights, taps, count);
    case 4:
      return combine_with<T, 4>(out, lines, first, weights, taps, count);
    case 5:
      return combine_with<T, 5>(out, lines, first, weights, taps, count);
    case 6:
      return combine_with<T, 6>(out, lines, first, weights, taps, count);
    case 8:
      return combine_with<T, 8>(out, lines, first, weights, taps, count);
    default:
      return combine_with<T, 0>(out, lines, first, weights, taps, count);
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

template <class T, int Taps>
[[gnu::always_inline]] inline Vec<T> strand_sum(const Strand<T>& strand, Index t) {
  const T* line = strand.line + t;
  return sum_of<T, Taps>(
      strand.weights,
      strand.taps, [&](int j) __attribute__((always_inline)) { return V<T>::load(line + j); });
}

template <class T>
[[gnu::always_inline]] inline Vec<T> strand_sum_of_any(const Strand<T>& strand, Index t) {
  switch (strand.taps) {
    case 1:
      return strand_sum<T, 1>(strand, t);
    case 2:
      return strand_sum<T, 2>(strand, t);
    case 3:
      return strand_sum<T, 3>(strand, t);
    case 4:
      return strand_sum<T, 4>(strand, t);
    case 5:
      return strand_sum<T, 5>(strand, t);
    case 6:
      return strand_sum<T, 6>(strand, t);
    default:
      return strand_sum<T, 0>(strand, t);
  }
}

// A block is one vector of turns: `block(t, out)` makes its Arity vectors.
template <class T, int Arity, class Block>
[[gnu::always_inline]] inline void weave_blocks(T* out, Index turns, bool stream, Block&& block) {
  constexpr int lanes = V<T>::lanes;
  Vec<T> woven[Arity];
  Index t = 0;
  if (stream) {
    for (; t + lanes <= turns; t += lanes, out += Arity * lanes) {
      block(t, woven);
#pragma GCC unroll 9
      for (int k = 0; k < Arity; ++k) V<T>::stream(out + k * lanes, woven[k]);
    }
  } else {
    for (; t + lanes <= turns; t += lanes, out += Arity * lanes) {
      block(t, woven);
#pragma GCC unroll 9
      for (int k = 0; k < Arity; ++k) V<T>::store(out + k * lanes, woven[k]);
    }
  }
  if (t < turns) {
    block(t, woven);
    Index rest = (turns - t) * Arity;
    int k = 0;
    // Full vectors go the same way: an ordinary store would wait for its line to be read.
    for (; stream && rest >= lanes; ++k, rest -= lanes) V<T>::stream(out + k * lanes, woven[k]);
    __builtin_memcpy(out + k * lanes, woven + k, static_cast<std::size_t>(rest) * sizeof(T));
  }
}

// Two phases with fixed taps: the binary schemes of the catalogue.
template <class T, int A, int B>
void weave_pair(T* __restrict out, const Strand<T>* strands, Index turns, bool stream) {
  T weights_a[A], weights_b[B];
  for (int j = 0; j < A; ++j) weights_a[j] = strands[0].weights[j];
  for (int j = 0; j < B; ++j) weights_b[j] = strands[1].weights[j];
  const Strand<T> a{strands[0].line, weights_a, A};
  const Strand<T> b{strands[1].line, weights_b, B};
  weave_blocks<T, 2>(
      out, turns, stream, [&](Index t, Vec<T> * woven) __attribute__((always_inline)) {
        weave_two<T>(strand_sum<T, A>(a, t), strand_sum<T, B>(b, t), woven);
      });
}

template <class T, int Arity>
void weave_some(T* __restrict out, const Strand<T>* strands, Index turns, bool stream) {
  weave_blocks<T, Arity>(
      out, turns, stream, [&](Index t, Vec<T> * woven) __attribute__((always_inline)) {
        Vec<T> phases[Arity];
#pragma GCC unroll 9
        for (int i = 0; i < Arity; ++i) phases[i] = strand_sum_of_any<T>(strands[i], t);
        weave_vectors<T, Arity>(phases, woven);
      });
}

template <class T>
void weave_any(T* __restrict out, const Strand<T>* strands, int arity, Index turns) {
  constexpr int lanes = V<T>::lanes;
  for (int i = 0; i < arity; ++i) {
    for (Index t = 0; t < turns; t += lanes) {
      const Vec<T> sum = strand_sum_of_any<T>(strands[i], t);
      const Index count = turns - t < lanes ? turns - t : lanes;
      for (Index k = 0; k < count; ++k) out[arity * (t + k) + i] = sum[k];
    }
  }
}

template <class T, int A>
void weave_from(T* out, const Strand<T>* strands, Index turns, bool stream) {
  switch (strands[1].taps) {
    case 1:
      return weave_pair<T, A, 1>(out, strands, turns, stream);
    case 2:
      return weave_pair<T, A, 2>(out, strands, turns, stream);
    case 3:
      return weave_pair<T, A, 3>(out, strands, turns, stream);
    case 4:
      return weave_pair<T, A, 4>(out, strands, turns, stream);
    case 6:
      if constexpr (A == 1) return weave_pair<T, A, 6>(out, strands, turns, stream);
      break;
    case 8:
      if constexpr (A == 1) return weave_pair<T, A, 8>(out, strands, turns, stream);
      break;
    default:
      break;
  }
  weave_some<T, 2>(out, strands, turns, stream);
}

template <class T>
void weave(T* out, const Strand<T>* strands, int arity, Index turns, bool stream) {
  switch (arity) {
    case 1:
      return weave_some<T, 1>(out, strands, turns, stream);
    case 2:
      switch (strands[0].taps) {
        case 1:
          return weave_from<T, 1>(out, strands, turns, stream);
        case 2:
          return weave_from<T, 2>(out, strands, turns, stream);
        case 3:
          return weave_from<T, 3>(out, strands, turns, stream);
        case 4:
          return weave_from<T, 4>(out, strands, turns, stream);
        case 6:
          if (strands[1].taps == 1) return weave_pair<T, 6, 1>(out, strands, turns, stream);
          break;
        case 8:
          if (strands[1].taps == 1) return weave_pair<T, 8, 1>(out, strands, turns, stream);
          break;
        default:
          break;
      }
      return weave_some<T, 2>(out, strands, turns, stream);
    case 3:
      return weave_some<T, 3>(out, strands, turns, stream);
    case 4:
      return weave_some<T, 4>(out, strands, turns, stream);
    case 9:
      return weave_some<T, 9>(out, strands, turns, stream);
    default:
      return weave_any<T>(out, strands, arity, turns);
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
