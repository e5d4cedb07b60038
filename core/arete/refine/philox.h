// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

namespace arete {

/// Philox-4x32 with 10 rounds, a counter-based generator: 128 random bits as a function of a
/// 128-bit counter and a 64-bit key, without state. Salmon, Moraes, Dror, Shaw, "Parallel random
/// numbers: as easy as 1, 2, 3", SC11, section 3.3.
struct Philox {
  static constexpr int rounds = 10;
  static constexpr std::uint32_t multiplier_0 = 0xD2511F53;
  static constexpr std::uint32_t multiplier_2 = 0xCD9E8D57;
  static constexpr std::uint32_t golden_ratio = 0x9E3779B9;
  static constexpr std::uint32_t square_root_3 = 0xBB67AE85;

  using Counter = std::array<std::uint32_t, 4>;
  using Key = std::array<std::uint32_t, 2>;

  /// One round on the words of a counter, all of them references so that lanes can be arrays.
  static void round(std::uint32_t& c0, std::uint32_t& c1, std::uint32_t& c2, std::uint32_t& c3,
                    std::uint32_t key_0, std::uint32_t key_1) {
    const std::uint64_t product_0 = std::uint64_t{multiplier_0} * c0;
    const std::uint64_t product_2 = std::uint64_t{multiplier_2} * c2;
    c0 = static_cast<std::uint32_t>(product_2 >> 32) ^ c1 ^ key_0;
    c1 = static_cast<std::uint32_t>(product_2);
    c2 = static_cast<std::uint32_t>(product_0 >> 32) ^ c3 ^ key_1;
    c3 = static_cast<std::uint32_t>(product_0);
  }

  [[nodiscard]] static Counter bits(Counter counter, Key key) {
    for (int i = 0; i < rounds; ++i) {
      round(counter[0], counter[1], counter[2], counter[3], key[0], key[1]);
      key[0] += golden_ratio;
      key[1] += square_root_3;
    }
    return counter;
  }
};

}  // namespace arete
