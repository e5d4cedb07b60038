// SPDX-License-Identifier: MIT
#include "arete/refine/combine.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <vector>

namespace arete {
namespace {

template <class T>
class CombineTest : public ::testing::Test {};
using Numbers = ::testing::Types<float, double>;
TYPED_TEST_SUITE(CombineTest, Numbers);

TYPED_TEST(CombineTest, equals_the_plain_reference_to_the_last_bit_for_every_remainder) {
  using T = TypeParam;
  std::mt19937 random(20061);
  std::uniform_real_distribution<T> number(-1000, 1000);
  const T sentinel = T(-7777);
  for (int taps = 0; taps <= 19; ++taps) {
    std::vector<T> weights;
    for (int i = 0; i < taps; ++i) weights.push_back(number(random));
    for (Index count = 0; count <= 70; ++count) {
      for (Index misalignment : {0, 1, 3}) {
        std::vector<std::vector<T>> lines(static_cast<std::size_t>(taps));
        std::vector<const T*> starts;
        for (auto& line : lines) {
          line.resize(static_cast<std::size_t>(count + misalignment + 1));
          for (T& v : line) v = number(random);
          starts.push_back(line.data() + misalignment);
        }
        std::vector<T> fast(static_cast<std::size_t>(count + 5), sentinel);
        std::vector<T> plain = fast;
        combine(fast.data() + 2, starts.data(), weights.data(), taps, count);
        combine_reference(plain.data() + 2, starts.data(), weights.data(), taps, count);
        // Bytes: also the samples before and behind must be untouched.
        ASSERT_EQ(std::memcmp(fast.data(), plain.data(), fast.size() * sizeof(T)), 0)
            << taps << " taps, " << count << " samples";
      }
    }
  }
}

TYPED_TEST(CombineTest, phases_are_put_in_their_places) {
  using T = TypeParam;
  for (Index count = 0; count <= 40; ++count) {
    std::vector<T> even, odd;
    for (Index i = 0; i < count; ++i) {
      even.push_back(static_cast<T>(2 * i));
      odd.push_back(static_cast<T>(2 * i + 1));
    }
    std::vector<T> woven(static_cast<std::size_t>(2 * count)), scattered = woven;
    interleave(woven.data(), even.data(), odd.data(), count);
    scatter(scattered.data(), even.data(), 2, count);
    if (count > 0) scatter(scattered.data() + 1, odd.data(), 2, count);
    for (Index i = 0; i < 2 * count; ++i)
      EXPECT_EQ(woven[static_cast<std::size_t>(i)], static_cast<T>(i));
    EXPECT_EQ(woven, scattered);
  }
}

}  // namespace
}  // namespace arete
