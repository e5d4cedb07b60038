// SPDX-License-Identifier: MIT
// What the exponents promise is what is measured: landscapes from one control grid are the rougher,
// the smaller the Hoelder exponent of their scheme, and stay where they are.
#include <gtest/gtest.h>

#include <cmath>

#include "arete/analysis/hoelder.h"
#include "arete/metrics/spectrum.h"
#include "arete/refine/refiner.h"
#include "arete/scheme/catalogue.h"
#include "support/fields.h"

namespace arete {
namespace {

// Slope of the power in the octaves that six levels made; not in the last ones, where the samples
// are not yet the limit.
double new_octaves(const Grid<double>& control, const Scheme& scheme) {
  const Grid<double> fine = refine(control, scheme, {.levels = 6});
  return spectral_slope(profile_spectrum(fine.view()), 0.5 / 64, 0.125).value().slope;
}

TEST(roughness, is_ordered_as_the_hoelder_exponents) {
  const Grid<double> control = test::random_heights({14, 14});
  double exponent_before = 0;
  double slope_before = 0;
  for (const char* text : {"craggy", "four-point:omega=1/5", "gentle", "b-spline:degree=3"}) {
    const Scheme scheme = parse_scheme(text);
    const double exponent = hoelder_bounds(scheme.mask()).lower;
    const double slope = new_octaves(control, scheme);
    EXPECT_GT(exponent, exponent_before) << text;
    EXPECT_LT(slope, slope_before) << text;
    // A profile whose heights differ by d^a over a distance d: about -(2 a + 1), at most.
    EXPECT_LT(slope, -(2 * exponent + 1) + 1) << text;
    exponent_before = exponent;
    slope_before = slope;
  }
}

TEST(roughness, both_printed_landscapes_keep_their_place) {
  // Heights are the eastings, then the northings, of a rotated map: exact numbers.
  const Georeference map{{512, 8, 4, 4096, 4, -8}, Registration::area};
  for (const bool east : {true, false}) {
    Grid<double> control({9, 12});
    for (Index r = 0; r < 9; ++r)
      for (Index c = 0; c < 12; ++c) {
        const WorldPoint p = map.position(static_cast<double>(r), static_cast<double>(c));
        control(r, c) = east ? p.x : p.y;
      }
    for (const char* text : {"gentle", "craggy"}) {
      const Refiner<double> refiner(parse_scheme(text), control.extent(), {.levels = 3});
      const Grid<double> fine = refiner(control.view());
      const Georeference place = refined(map, refiner);
      for (Index r = 0; r < fine.rows(); ++r)
        for (Index c = 0; c < fine.cols(); ++c) {
          const WorldPoint p = place.position(static_cast<double>(r), static_cast<double>(c));
          ASSERT_NEAR(fine(r, c), east ? p.x : p.y, 1e-9) << text;
        }
    }
  }
}

}  // namespace
}  // namespace arete
