// SPDX-License-Identifier: MIT
// Reverse subdivision of a raster beside refining to it: the same raster, the same scheme, one
// thread, in one process and by turns, so that other work on the machine hits all alike.
//
// Results are in pages of 2 MiB where the system offers them. `4 KiB` is refining to ordinary
// pages: what the first touch of memory costs without them.
//
//     bench_reverse_raster [COLS [ROWS [LEVELS [ROUNDS]]]]        6433 5489 4 3
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "arete/refine/refiner.h"
#include "arete/reverse/grid_reverse.h"
#include "arete/scheme/catalogue.h"

namespace {

using arete::Extent;
using arete::Grid;
using arete::Index;

template <class F>
void time_least(double& least, F&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  least = std::min(least, spent.count());
}

struct Case {
  const char* scheme;
  arete::ReverseMode mode;
};

struct Times {
  double refine = 1e300;
  double refine_small_pages = 1e300;
  double apart = 1e300;
  double together = 1e300;
  float error = 0;
};

Grid<float> terrain(Extent extent) {
  Grid<float> heights(extent);
  for (Index r = 0; r < extent.rows; ++r)
    for (Index c = 0; c < extent.cols; ++c) {
      const auto x = static_cast<float>(c);
      const auto y = static_cast<float>(r);
      heights(r, c) = 300 * std::sin(x / 9) * std::cos(y / 7) + 20 * std::sin(x * y);
    }
  return heights;
}

Times measure(const Case& one, Extent fine_extent, int levels, int rounds) {
  const arete::Scheme scheme = arete::parse_scheme(one.scheme);
  const arete::GridReverseOptions reverse{levels, one.mode, {}, 1};
  const arete::GridPyramid pyramid(scheme.mask(), fine_extent, reverse);
  const Grid<float> coarse = terrain(pyramid.extent(levels));
  arete::RefineOptions options;
  options.levels = levels;
  const arete::Refiner<float> refiner(scheme, coarse.extent(), options);
  Times times;
  for (int round = 0; round < rounds; ++round) {
    Grid<float> fine;
    time_least(times.refine, [&] { fine = arete::refine(coarse, scheme, options); });
    time_least(times.refine_small_pages,
               [&] { (void)refiner.plane(std::as_const(coarse).view(), arete::Pages::ordinary); });
    arete::GridDecomposition<float> parts;
    time_least(times.apart, [&] {
      parts = arete::decompose_grid<float>(std::as_const(fine).view(), scheme, reverse);
    });
    Grid<float> again;
    time_least(times.together, [&] {
      again = arete::reconstruct_grid(parts, fine.extent(), scheme, reverse, levels);
    });
    for (std::size_t i = 0; i < fine.samples().size(); ++i)
      times.error = std::max(times.error, std::abs(again.samples()[i] - fine.samples()[i]));
  }
  return times;
}

}  // namespace

int main(int argc, char** argv) {
  const auto argument = [&](int i, long fallback) {
    return argc > i ? std::strtol(argv[i], nullptr, 10) : fallback;
  };
  const Extent extent{argument(2, 5489), argument(1, 6433)};
  const int levels = static_cast<int>(argument(3, 4));
  const int rounds = static_cast<int>(argument(4, 3));
  std::printf(
      "%lld x %lld samples (float), %d levels, 1 thread; seconds, the best of %d rounds\n\n",
      static_cast<long long>(extent.cols), static_cast<long long>(extent.rows), levels, rounds);
  std::printf("| scheme | mode | refine | refine, 4 KiB | apart | together ");
  std::printf("| both / refine | both / refine, 4 KiB | largest error |\n");
  std::printf("|---|---|---|---|---|---|---|---|---|\n");
  using enum arete::ReverseMode;
  for (const Case& one : {Case{"four-point", local}, Case{"b-spline:degree=3", local},
                          Case{"chaikin", local}, Case{"b-spline:degree=3", least_squares},
                          Case{"chaikin", least_squares}, Case{"gentle", least_squares}}) {
    const Times times = measure(one, extent, levels, rounds);
    const double both = times.apart + times.together;
    std::printf("| %s | %s | %.3f | %.3f | %.3f | %.3f | %.1f | %.1f | %.1e |\n", one.scheme,
                std::string(to_string(one.mode)).c_str(), times.refine, times.refine_small_pages,
                times.apart, times.together, both / times.refine, both / times.refine_small_pages,
                static_cast<double>(times.error));
    std::fflush(stdout);
  }
}
