// SPDX-License-Identifier: MIT
#include "arete/refine/kernel/kernel.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <random>
#include <string>

namespace arete {
namespace {

template <class T>
class KernelTest : public ::testing::Test {
 protected:
  // Samples, and the slack that kernels may read.
  std::vector<T> line(Index count) {
    std::vector<T> samples(static_cast<std::size_t>(count + kernel_slack));
    for (T& v : samples) v = number_(random_);
    return samples;
  }

 private:
  std::mt19937 random_{20061};
  std::uniform_real_distribution<T> number_{-1000, 1000};
};
using Numbers = ::testing::Types<float, double>;
TYPED_TEST_SUITE(KernelTest, Numbers);

constexpr int guard = 8;

// Memory on a cache line, with guards around the samples that may be written.
template <class T>
struct Output {
  explicit Output(Index count, Index misalignment = 0)
      : samples(static_cast<std::size_t>(count + 16 + misalignment + 2 * guard), T(-7777)),
        offset(misalignment) {}
  [[nodiscard]] T* start() {
    void* place = samples.data() + guard;
    std::size_t space = (samples.size() - guard) * sizeof(T);
    return static_cast<T*>(std::align(64, sizeof(T), place, space)) + offset;
  }
  std::vector<T> samples;
  Index offset;
};

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

TYPED_TEST(KernelTest, combine_equals_the_plain_reference_to_the_last_bit_for_every_remainder) {
  using T = TypeParam;
  for (const Kernels<T>* kernels : available_kernels<T>()) {
    for (int taps : {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 19, 64, 70}) {
      const std::vector<T> weights = this->line(taps);
      for (Index count = 0; count <= 70; ++count) {
        for (Index first : {0, 1, 3}) {
          std::vector<std::vector<T>> lines;
          std::vector<const T*> starts, shifted;
          for (int i = 0; i < taps; ++i) lines.push_back(this->line(count + first));
          for (const auto& line : lines) {
            starts.push_back(line.data());
            shifted.push_back(line.data() + first);
          }
          Output<T> fast(count), plain(count);
          std::memcpy(fast.samples.data(), plain.samples.data(), sizeof(T));
          kernels->combine(fast.samples.data() + guard, starts.data(), first, weights.data(), taps,
                           count);
          combine_reference(plain.samples.data() + guard, shifted.data(), weights.data(), taps,
                            count);
          ASSERT_TRUE(same_bytes(fast.samples, plain.samples))
              << kernels->name << ", " << taps << " taps, " << count << " samples";
        }
      }
    }
  }
}

TYPED_TEST(KernelTest, weave_equals_the_plain_reference_to_the_last_bit_for_every_remainder) {
  using T = TypeParam;
  std::mt19937 random(7);
  for (const Kernels<T>* kernels : available_kernels<T>()) {
    for (int arity : {1, 2, 3, 4, 5, 9, 11}) {
      // Binary: every pair of fixed taps; otherwise taps of all kinds.
      for (int variant = 0; variant < (arity == 2 ? 100 : 12); ++variant) {
        std::vector<std::vector<T>> lines, weights;
        for (int i = 0; i < arity; ++i) {
          const int taps =
              arity == 2 ? (i == 0 ? variant % 10 : variant / 10) : static_cast<int>(random() % 10);
          weights.push_back(this->line(taps));
          weights.back().resize(static_cast<std::size_t>(taps));
          lines.push_back(this->line(80));
        }
        for (Index turns : {0, 1, 3, 4, 7, 8, 15, 16, 17, 33, 64}) {
          std::vector<Strand<T>> strands;
          for (std::size_t i = 0; i < lines.size(); ++i)
            strands.push_back(
                {lines[i].data() + i % 3, weights[i].data(), static_cast<int>(weights[i].size())});
          for (bool stream : {false, true}) {
            const Index misalignment = stream ? 0 : turns % 5;
            Output<T> fast(arity * turns, misalignment);
            Output<T> plain(arity * turns, misalignment);
            kernels->weave(fast.start(), strands.data(), arity, turns, stream);
            kernels->fence();
            weave_reference(plain.start(), strands.data(), arity, turns);
            ASSERT_EQ(std::memcmp(
                          fast.start() - guard, plain.start() - guard,
                          static_cast<std::size_t>(arity * turns + guard + guard / 2) * sizeof(T)),
                      0)
                << kernels->name << ", arity " << arity << ", " << turns << " turns";
          }
        }
      }
    }
  }
}

TYPED_TEST(KernelTest, one_sample_that_is_not_finite_is_found_wherever_it_is) {
  using T = TypeParam;
  using Limits = std::numeric_limits<T>;
  for (const Kernels<T>* kernels : available_kernels<T>()) {
    for (Index count = 0; count <= 70; ++count) {
      std::vector<T> samples = this->line(count);
      if (count > 0) samples[0] = Limits::max();
      if (count > 1) samples[1] = Limits::denorm_min();
      EXPECT_TRUE(kernels->all_finite(samples.data(), count));
      for (Index at = 0; at < count; ++at)
        for (T bad : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()}) {
          std::vector<T> spoilt = samples;
          spoilt[static_cast<std::size_t>(at)] = bad;
          ASSERT_FALSE(kernels->all_finite(spoilt.data(), count)) << kernels->name << at;
        }
    }
  }
}

TEST(kernels, the_plainest_set_is_always_there_and_the_best_is_the_default) {
  ASSERT_FALSE(available_kernels<float>().empty());
  EXPECT_EQ(available_kernels<float>().front()->name, "baseline");
  if (std::getenv("ARETE_KERNEL") != nullptr) return;
  EXPECT_EQ(&kernels<float>(), available_kernels<float>().back());
}

}  // namespace
}  // namespace arete
