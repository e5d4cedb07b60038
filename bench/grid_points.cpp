// SPDX-License-Identifier: MIT
// Scattered points to a grid: time and memory of each method for a number of points (default one
// million) and as many samples. Prints Markdown.
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "arete/cgal/scattered_grid.h"

namespace {

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace arete::cgal;
  const long count = argc > 1 ? std::atol(argv[1]) : 1000000;
  const auto side = static_cast<arete::Index>(std::sqrt(static_cast<double>(count)));
  std::mt19937 random(1);
  // UTM-like coordinates of a 30 km square.
  std::uniform_real_distribution<double> place(0, 30000);
  std::vector<double> x, y, z;
  for (long i = 0; i < count; ++i) {
    x.push_back(500000 + place(random));
    y.push_back(4600000 + place(random));
    z.push_back(500 + 200 * std::sin(x.back() / 900) * std::cos(y.back() / 1300));
  }
  std::printf("%ld points, %ld x %ld samples\n\n", count, static_cast<long>(side),
              static_cast<long>(side));
  std::printf(
      "| method | threads | seconds | points/s | peak memory of the process so far, MB |\n");
  std::printf("|---|---|---|---|---|\n");
  for (const GridMethod method :
       {GridMethod::linear, GridMethod::inverse_distance, GridMethod::natural_neighbour})
    for (const int threads : {1, 2}) {
      const auto start = std::chrono::steady_clock::now();
      const GriddedPoints grid = grid_points(
          {x, y, z}, {.size = arete::Extent{side, side}, .method = method, .threads = threads});
      const double seconds =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      std::printf("| %s | %d | %.2f | %.0f | %.0f |\n", std::string(to_string(method)).c_str(),
                  threads, seconds, static_cast<double>(grid.used) / seconds, peak_megabytes());
      std::fflush(stdout);
    }
}
