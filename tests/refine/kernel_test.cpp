// SPDX-License-Identifier: MIT
#include "arete/refine/kernel/kernel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <string>

#include "arete/refine/kernel/shape.h"
#include "arete/refine/level_rule.h"
#include "support/schemes.h"

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
        std::vector<std::vector<T>> lines;
        std::vector<const T*> starts;
        for (int i = 0; i < taps; ++i) lines.push_back(this->line(count));
        for (const auto& line : lines) starts.push_back(line.data());
        Output<T> fast(count), plain(count);
        std::memcpy(fast.samples.data(), plain.samples.data(), sizeof(T));
        kernels->combine(fast.samples.data() + guard, starts.data(), weights.data(), taps, count);
        combine_reference(plain.samples.data() + guard, starts.data(), weights.data(), taps, count);
        ASSERT_TRUE(same_bytes(fast.samples, plain.samples))
            << kernels->name << ", " << taps << " taps, " << count << " samples";
      }
    }
  }
}

// A row of `width` samples woven by the kernels and by the plain reference, for every remainder of
// a vector, with and without streaming.
template <class T>
void expect_weave_of_the_reference(const Kernels<T>& kernels, int warp_taps,
                                   const std::vector<Strand<T>>& strands, Index longest,
                                   const std::function<std::vector<T>(Index)>& line) {
  const auto arity = static_cast<int>(strands.size());
  const Weave<T> weave = kernels.weave_for(warp_taps, strands.data(), arity);
  ASSERT_NE(weave, nullptr);
  for (const Index count : {0, 1, 3, 4, 7, 8, 15, 16, 17, 31, 33, 64, 65, 143, 145, 300}) {
    const Index read = count / arity + 1 + longest;
    std::vector<std::vector<T>> lines;
    std::vector<const T*> starts;
    for (int i = 0; i < std::max(1, warp_taps); ++i) lines.push_back(line(read));
    for (const auto& samples : lines) starts.push_back(samples.data());
    const std::vector<T> weights = line(warp_taps);
    std::vector<T> sums = lines[0];
    if (warp_taps > 0)
      combine_reference(sums.data(), starts.data(), weights.data(), warp_taps, read);
    for (const bool stream : {false, true}) {
      const Index misalignment = stream ? 0 : count % 5;
      Output<T> fast(count, misalignment);
      Output<T> plain(count, misalignment);
      weave(fast.start(), {starts.data(), weights.data(), warp_taps}, strands.data(), arity, count,
            stream);
      kernels.fence();
      weave_reference(plain.start(), sums.data(), strands.data(), arity, count);
      ASSERT_EQ(std::memcmp(fast.start() - guard, plain.start() - guard,
                            static_cast<std::size_t>(count + guard + guard / 2) * sizeof(T)),
                0)
          << kernels.name << ", arity " << arity << ", warp of " << warp_taps << ", " << count
          << " samples";
    }
  }
}

TYPED_TEST(KernelTest, weave_equals_the_plain_reference_to_the_last_bit_for_every_remainder) {
  using T = TypeParam;
  std::mt19937 random(7);
  for (const Kernels<T>* kernels : available_kernels<T>()) {
    for (int arity : {1, 2, 3, 4, 5, 9, 11}) {
      // Binary: every pair of taps, otherwise taps of all kinds.
      for (int variant = 0; variant < (arity == 2 ? 100 : 12); ++variant) {
        std::vector<std::vector<T>> weights;
        std::vector<Strand<T>> strands;
        for (int i = 0; i < arity; ++i) {
          const int taps =
              arity == 2 ? (i == 0 ? variant % 10 : variant / 10) : static_cast<int>(random() % 10);
          weights.push_back(this->line(taps));
          strands.push_back({static_cast<Index>(random() % 3), weights.back().data(), taps});
        }
        expect_weave_of_the_reference<T>(*kernels, 0, strands, 12,
                                         [&](Index count) { return this->line(count); });
      }
    }
  }
}

TYPED_TEST(KernelTest, every_shape_is_woven_as_the_plain_reference_does_to_the_last_bit) {
  using T = TypeParam;
  for (const Kernels<T>* kernels : available_kernels<T>()) {
    for (const Shape& shape : shapes) {
      std::vector<std::vector<T>> weights;
      std::vector<Strand<T>> strands;
      for (std::size_t i = 0; i < static_cast<std::size_t>(shape.arity); ++i) {
        weights.push_back(this->line(shape.taps[i]));
        strands.push_back({shape.first[i] + 2, weights.back().data(), shape.taps[i]});
      }
      for (const int warp_taps : {0, shape.taps[0], shape.taps[strands.size() - 1]})
        if (kernels->weave_for(warp_taps, strands.data(), shape.arity) != nullptr)
          expect_weave_of_the_reference<T>(*kernels, warp_taps, strands, 12,
                                           [&](Index count) { return this->line(count); });
    }
  }
}

TEST(Shapes, those_of_the_catalogue_are_known_wherever_a_row_begins) {
  using T = float;
  for (const Scheme& scheme : test::sample_schemes()) {
    // None of the catalogue; one whose outer weights vanish.
    if (scheme.mask().arity() == 4 || scheme.text() == "ternary-two-step:b=-3/8") continue;
    const PhasedRule<T> rule(LevelRule{scheme.mask().arity(), scheme.mask().symbol()});
    const int turns = rule.arity == 9 ? 1 : rule.arity;
    for (int start = 0; start < turns; ++start) {
      std::vector<Strand<T>> strands;
      for (int i = start; i < start + rule.arity; ++i) {
        const auto& phase = rule.phases[static_cast<std::size_t>(i % rule.arity)];
        strands.push_back({i / rule.arity + phase.first + 9, phase.weights.data(),
                           static_cast<int>(phase.weights.size())});
      }
      const auto shape = [&] {
        return std::any_of(shapes.begin(), shapes.end(), [&](const Shape& known) {
          bool same = known.arity == rule.arity;
          for (std::size_t i = 0; same && i < strands.size(); ++i)
            same = known.taps[i] == strands[i].taps &&
                   known.first[i] - known.first[0] == strands[i].offset - strands[0].offset;
          return same;
        });
      };
      EXPECT_TRUE(shape()) << scheme.text() << " from phase " << start;
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
