// SPDX-License-Identifier: MIT
#include "arete/refine/noise.h"

#include <algorithm>

namespace arete {
namespace {

std::int32_t sum_of_four(std::uint32_t a, std::uint32_t b) {
  constexpr std::int32_t mean = 2 * 65535;
  return static_cast<std::int32_t>((a & 0xFFFF) + (a >> 16) + (b & 0xFFFF) + (b >> 16)) - mean;
}

std::uint32_t low(Index value) {
  return static_cast<std::uint32_t>(static_cast<std::uint64_t>(value));
}
std::uint32_t high(Index value) {
  return static_cast<std::uint32_t>(static_cast<std::uint64_t>(value) >> 32);
}

}  // namespace

Philox::Counter NoiseRow::counter(Index pair) const {
  // An axis has at most 2^40 samples: 16 bits hold what is above 32, and the sign.
  return {low(pair), low(row), (high(pair) & 0xFFFF) | (high(row) << 16),
          static_cast<std::uint32_t>(level)};
}

Philox::Key NoiseRow::key() const {
  return {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)};
}

std::int32_t NoiseRow::at(Index column) const {
  const Index pair = floor_divide(column, 2);
  const Philox::Counter bits = Philox::bits(counter(pair), key());
  return column == 2 * pair ? sum_of_four(bits[0], bits[1]) : sum_of_four(bits[2], bits[3]);
}

void NoiseRow::fill(IndexRange columns, std::int32_t* out) const {
  // Lanes side by side, so that the compiler can use vectors.
  constexpr int lanes = 16;
  std::uint32_t c[4][lanes];
  const Index last_pair = floor_divide(columns.last, 2);
  for (Index pair = floor_divide(columns.first, 2); pair <= last_pair; pair += lanes) {
    for (int i = 0; i < lanes; ++i) {
      const Philox::Counter start = counter(pair + i);
      for (std::size_t word = 0; word < 4; ++word) c[word][i] = start[word];
    }
    Philox::Key k = key();
    for (int r = 0; r < Philox::rounds; ++r) {
      for (int i = 0; i < lanes; ++i) Philox::round(c[0][i], c[1][i], c[2][i], c[3][i], k[0], k[1]);
      k[0] += Philox::golden_ratio;
      k[1] += Philox::square_root_3;
    }
    std::int32_t values[2 * lanes];
    for (int i = 0; i < lanes; ++i) {
      values[2 * i] = sum_of_four(c[0][i], c[1][i]);
      values[2 * i + 1] = sum_of_four(c[2][i], c[3][i]);
    }
    const Index first = std::max(2 * pair, columns.first);
    const Index last = std::min(2 * pair + 2 * lanes - 1, columns.last);
    std::copy(values + (first - 2 * pair), values + (last - 2 * pair) + 1,
              out + (first - columns.first));
  }
}

}  // namespace arete
