// SPDX-License-Identifier: MIT
// The C++ lines of the README: a grid of heights, refined three levels.
#include <arete/refine/refiner.h>
#include <arete/scheme/catalogue.h>

#include <cstdio>

int main() {
  arete::Grid<float> coarse({9, 9});
  coarse(4, 4) = 100;
  const auto scheme = arete::parse_scheme("four-point:omega=1/16");
  const arete::Grid<float> fine = arete::refine(coarse, scheme, {.levels = 3});
  std::printf("%lld x %lld, summit %g\n", static_cast<long long>(fine.cols()),
              static_cast<long long>(fine.rows()), fine(32, 32));
  return fine.cols() == 65 && fine(32, 32) == 100 ? 0 : 1;
}
