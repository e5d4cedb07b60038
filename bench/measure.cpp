// SPDX-License-Identifier: MIT
#include "measure.h"

#include <cmath>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace arete::bench {

void fill_past_cache(float* samples, Index count) {
#if defined(__SSE2__)
  const __m128 value = _mm_set1_ps(1.5F);
  Index i = 0;
  for (; i + 16 <= count; i += 16)
    for (Index k = 0; k < 16; k += 4) _mm_stream_ps(samples + i + k, value);
  for (; i < count; ++i) samples[i] = 1.5F;
  _mm_sfence();
#else
  std::fill_n(samples, count, 1.5F);
#endif
}

Grid<float> terrain(Extent extent) {
  Grid<float> grid(extent);
  for (Index r = 0; r < extent.rows; ++r)
    for (Index c = 0; c < extent.cols; ++c) {
      const auto x = static_cast<double>(c);
      const auto y = static_cast<double>(r);
      grid(r, c) = static_cast<float>(450 + 200 * std::sin(x / 31) * std::cos(y / 23) +
                                      20 * std::sin(x / 3 + y / 2) + std::sin(x * y));
    }
  return grid;
}

}  // namespace arete::bench
