// SPDX-License-Identifier: MIT
// Numbers at the ends of their ranges: more than 2^31 samples along an axis, denormals, infinities,
// heights far from zero, masks of a thousand taps.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "arete/refine/refiner.h"
#include "arete/scheme/catalogue.h"

namespace arete {
namespace {

constexpr Index beyond_int = (Index{1} << 31) + 16;

/// Rows that repeat after 16, as many as wanted, in no memory.
class Repeating final : public RowSource<float> {
 public:
  explicit Repeating(Extent extent) : extent_(extent) {}
  [[nodiscard]] Extent extent() const override { return extent_; }
  void read(Index r, float* out) const override {
    for (Index c = 0; c < extent_.cols; ++c)
      out[c] = static_cast<float>(std::sin(static_cast<double>(r % 16) * 0.7) + 0.1 * c * c);
  }

 private:
  Extent extent_;
};

bool same_bits(const Grid<float>& a, const Grid<float>& b) {
  return a.extent() == b.extent() &&
         std::memcmp(a.row(0), b.row(0), a.samples().size() * sizeof(float)) == 0;
}

TEST(numbers, more_than_two_to_the_31_columns_are_planned_exactly_and_too_many_are_refused) {
  const Mask mask = parse_scheme("four-point").mask();
  AxisOptions options;
  options.levels = 3;
  const AxisPlan plan(mask, beyond_int, options);
  EXPECT_EQ(plan.output_count(), 8 * (beyond_int - 1) + 1);
  EXPECT_EQ(Rational(plan.first_position() + plan.spacing() * (plan.output_count() - 1)),
            Rational(beyond_int - 1));
  options.levels = 20;
  EXPECT_THROW(AxisPlan(mask, beyond_int, options), InvalidField);
  options.levels = 0;
  EXPECT_THROW(AxisPlan(mask, std::numeric_limits<Index>::max(), options), InvalidField);
  EXPECT_THROW(AxisPlan(mask, std::numeric_limits<Index>::min(), options), InvalidField);
}

TEST(numbers, rows_beyond_two_to_the_31_are_refined_as_those_before) {
  const Repeating source({beyond_int, 5});
  for (const char* name : {"gentle", "chaikin", "ternary-four-point:mu=1/11"}) {
    const Scheme scheme = parse_scheme(name);
    const Refiner<float> refiner(scheme, source.extent(), {.levels = 2});
    const Index arity = Index{scheme.mask().arity()} * scheme.mask().arity();
    Grid<float> early({40, refiner.output().cols}), late = early;
    refiner.refine_rows(source, arity * 32, early.view());
    refiner.refine_rows(source, arity * (beyond_int - 32), late.view());
    EXPECT_TRUE(same_bits(early, late)) << name;
  }
}

TEST(numbers, denormals_are_numbers_and_not_zero) {
  constexpr float least = std::numeric_limits<float>::denorm_min();
  Grid<float> grid({6, 6});
  for (Index r = 0; r < 6; ++r)
    for (Index c = 0; c < 6; ++c) grid(r, c) = static_cast<float>(1024 + 64 * r + 16 * c) * least;
  const Refiner<float> refiner(parse_scheme("four-point"), grid.extent(), {.levels = 2});
  const Grid<float> fine = refiner(grid.view());
  for (Index r = 0; r < fine.rows(); ++r)
    for (Index c = 0; c < fine.cols(); ++c)
      ASSERT_NEAR(fine(r, c) / least, 1024 + 16.0 * r + 4.0 * c, 8) << r << ", " << c;
}

TEST(numbers, an_infinity_is_a_missing_sample_like_any_other) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  Grid<float> missing({7, 8});
  for (Index r = 0; r < 7; ++r)
    for (Index c = 0; c < 8; ++c) missing(r, c) = static_cast<float>(r * r - 3 * c);
  missing(3, 4) = std::numeric_limits<float>::quiet_NaN();
  for (const char* name : {"gentle", "b-spline:degree=3"}) {
    const Refiner<float> refiner(parse_scheme(name), missing.extent(), {.levels = 2});
    const Grid<float> expected = refiner(missing.view());
    for (const float value : {infinity, -infinity}) {
      Grid<float> grid = missing;
      grid(3, 4) = value;
      EXPECT_TRUE(same_bits(refiner(grid.view()), expected)) << name << ", " << value;
    }
  }
}

// A height far from zero loses some of the last places of its type (craggy 19, the others fewer)
// and nothing beyond.
TEST(numbers, heights_of_geocentric_size_lose_no_more_than_their_own_last_places) {
  for (const double offset : {500000.0, 6378137.0, -6378137.0}) {
    Grid<float> grid({9, 9});
    Grid<double> exact({9, 9});
    for (Index r = 0; r < 9; ++r)
      for (Index c = 0; c < 9; ++c) {
        grid(r, c) = static_cast<float>(offset + 100 * std::sin(static_cast<double>(r * 3 + c)));
        exact(r, c) = static_cast<double>(grid(r, c)) - offset;
      }
    const double last_place = std::nextafter(std::abs(static_cast<float>(offset)), 1e30F) -
                              std::abs(static_cast<float>(offset));
    for (const char* name : {"gentle", "craggy", "four-point", "b-spline:degree=3"}) {
      const Scheme scheme = parse_scheme(name);
      const Grid<float> fine = refine(grid, scheme, {.levels = 4});
      const Grid<double> truth = refine(exact, scheme, {.levels = 4});
      double worst = 0;
      for (Index i = 0; i < fine.rows() * fine.cols(); ++i) {
        const auto k = static_cast<std::size_t>(i);
        worst = std::max(
            worst, std::abs(static_cast<double>(fine.samples()[k]) - offset - truth.samples()[k]));
      }
      EXPECT_LE(worst, 32 * last_place) << name << " at " << offset;
    }
  }
}

TEST(numbers, coordinates_of_a_projected_plane_stay_on_it_to_a_nanometre_in_double) {
  Grid<double> east({8, 8});
  for (Index r = 0; r < 8; ++r)
    for (Index c = 0; c < 8; ++c)
      east(r, c) = 500000 + 30 * static_cast<double>(c) + static_cast<double>(r);
  for (const char* name : {"gentle", "four-point", "chaikin"}) {
    const Refiner<double> refiner(parse_scheme(name), east.extent(), {.levels = 5});
    const Grid<double> fine = refiner(east.view());
    for (Index r = 0; r < fine.rows(); ++r)
      for (Index c = 0; c < fine.cols(); ++c) {
        const double x = to_double(refiner.x().first_position() + refiner.x().spacing() * c);
        const double y = to_double(refiner.y().first_position() + refiner.y().spacing() * r);
        ASSERT_NEAR(fine(r, c), 500000 + 30 * x + y, 1e-8) << name;
      }
  }
}

TEST(numbers, a_mask_of_a_thousand_taps_keeps_planes) {
  // The square of a box of 500: a hat of 999 taps with two sum rules.
  std::vector<Rational> taps;
  for (int k = 1; k < 1000; ++k) taps.emplace_back(k <= 500 ? k : 1000 - k, 125000);
  const Scheme scheme("mask", {}, Mask(2, -499, taps));
  Grid<double> plane({4, 5});
  for (Index r = 0; r < 4; ++r)
    for (Index c = 0; c < 5; ++c) plane(r, c) = 3 * static_cast<double>(c) - 2.0 * r + 7;
  const Refiner<double> refiner(scheme, plane.extent(), {.levels = 2});
  const Grid<double> fine = refiner(plane.view());
  for (Index r = 0; r < fine.rows(); ++r)
    for (Index c = 0; c < fine.cols(); ++c) {
      const double x = to_double(refiner.x().first_position() + refiner.x().spacing() * c);
      const double y = to_double(refiner.y().first_position() + refiner.y().spacing() * r);
      ASSERT_NEAR(fine(r, c), 3 * x - 2 * y + 7, 1e-9) << r << ", " << c;
    }
}

TEST(numbers, one_sample_is_a_constant_for_every_scheme) {
  Grid<float> one({1, 1}, 12.5F);
  for (const Family& family : catalogue()) {
    Scheme scheme = parse_scheme("gentle");
    try {
      scheme = make_scheme(family.name);
    } catch (const InvalidScheme&) {
      continue;  // it has parameters without defaults
    }
    const Grid<float> fine = refine(one, scheme, {.levels = 3});
    for (const float sample : fine.samples()) EXPECT_NEAR(sample, 12.5F, 1e-5F) << family.name;
  }
}

}  // namespace
}  // namespace arete
