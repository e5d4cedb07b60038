// SPDX-License-Identifier: MIT
// Holds the kernels of the machine it is compiled for to the plain references, to the last bit.
// Stands alone, so that it can be compiled for another processor without its libraries.
#include <cstdio>
#include <cstring>
#include <random>
#include <vector>

#include "arete/refine/kernel/kernel.h"
#include "arete/refine/kernel/shape.h"

namespace {

using namespace arete;

template <class T>
class Check {
 public:
  Check() {
    for (const Shape& shape : shapes) weave(shape);
    for (const int arity : {1, 2, 3, 4, 5, 9}) {
      Shape any{arity, {}, {}};
      for (std::size_t i = 0; i < static_cast<std::size_t>(arity); ++i)
        any.taps[i] = static_cast<int>(1 + random_() % 9);
      weave(any);
    }
    for (int taps = 0; taps < 20; ++taps) combine(taps);
  }

  int compared = 0;
  int different = 0;

 private:
  std::vector<T> line(Index count) {
    std::vector<T> samples(static_cast<std::size_t>(count + kernel_slack));
    for (T& v : samples) v = number_(random_);
    return samples;
  }

  void expect_same(const std::vector<T>& a, const std::vector<T>& b) {
    ++compared;
    if (std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) != 0) ++different;
  }

  void weave(const Shape& shape) {
    std::vector<std::vector<T>> weights;
    std::vector<Strand<T>> strands;
    for (std::size_t i = 0; i < static_cast<std::size_t>(shape.arity); ++i) {
      weights.push_back(line(shape.taps[i]));
      strands.push_back({shape.first[i], weights.back().data(), shape.taps[i]});
    }
    for (const Index count : {1, 7, 16, 33, 150}) {
      const std::vector<T> samples = line(count + 20);
      const T* const start = samples.data();
      std::vector<T> fast(static_cast<std::size_t>(count)), plain(fast);
      kernels<T>().weave_for(0, strands.data(), shape.arity)(
          fast.data(), {&start, nullptr, 0}, strands.data(), shape.arity, count, false);
      weave_reference(plain.data(), start, strands.data(), shape.arity, count);
      expect_same(fast, plain);
    }
  }

  void combine(int taps) {
    const std::vector<T> weights = line(taps);
    for (const Index count : {1, 7, 16, 33, 150}) {
      std::vector<std::vector<T>> lines;
      std::vector<const T*> starts;
      for (int i = 0; i < taps; ++i) lines.push_back(line(count));
      for (const auto& samples : lines) starts.push_back(samples.data());
      std::vector<T> fast(static_cast<std::size_t>(count)), plain(fast);
      kernels<T>().combine(fast.data(), starts.data(), weights.data(), taps, count);
      combine_reference(plain.data(), starts.data(), weights.data(), taps, count);
      expect_same(fast, plain);
    }
  }

  std::mt19937 random_{20061};
  std::uniform_real_distribution<T> number_{-1000, 1000};
};

}  // namespace

int main() {
  const Check<float> single;
  const Check<double> twice;
  const int compared = single.compared + twice.compared;
  const int different = single.different + twice.different;
  std::printf("%d rows compared, %d differ\n", compared, different);
  return compared > 500 && different == 0 ? 0 : 1;
}
