// SPDX-License-Identifier: MIT
// Laws over the whole catalogue, all boundaries, and sizes from one sample to primes.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "arete/analysis/polynomial.h"
#include "arete/refine/refiner.h"
#include "support/fields.h"
#include "support/schemes.h"

namespace arete {
namespace {

constexpr Boundary every_boundary[]{Boundary::extrapolate, Boundary::clamp, Boundary::reflect,
                                    Boundary::periodic, Boundary::none};
constexpr Extent every_extent[]{{1, 1}, {1, 6}, {5, 1}, {2, 2}, {3, 4}, {7, 13}, {11, 8}};

// Calls law(scheme, options, extent) for every combination that has a result.
template <class Law>
void for_all(Law&& law) {
  for (const Scheme& scheme : test::sample_schemes()) {
    for (Boundary boundary : every_boundary) {
      for (Alignment alignment : {Alignment::nodes, Alignment::cells}) {
        for (Extent extent : every_extent) {
          RefineOptions options;
          options.levels = scheme.mask().arity() > 2 ? 1 : 2;
          options.boundaries = {boundary, boundary};
          options.alignment = alignment;
          if (boundary == Boundary::none) {
            // Whether anything is left is the law of axis_plan_test; here only results count.
            try {
              (void)Refiner<double>(scheme, extent, options);
            } catch (const InvalidField&) {
              continue;
            }
          }
          law(scheme, options, extent);
        }
      }
    }
  }
}

TEST(catalogue_laws, the_samples_of_the_laws_cover_every_family) {
  std::set<std::string> families;
  for (const Scheme& scheme : test::sample_schemes()) families.insert(scheme.name());
  for (const Family& family : catalogue())
    EXPECT_EQ(families.count(family.name), 1u) << family.name;
}

TEST(catalogue_laws, constants_stay) {
  for_all([](const Scheme& scheme, const RefineOptions& options, Extent extent) {
    const Grid<double> fine = refine(Grid<double>(extent, 731.25), scheme, options);
    for (double v : fine.samples()) ASSERT_NEAR(v, 731.25, 1e-12 * 731.25) << scheme.text();
  });
}

TEST(catalogue_laws, schemes_with_two_sum_rules_keep_planes_at_their_tau_positions) {
  for_all([](const Scheme& scheme, const RefineOptions& options, Extent extent) {
    if (sum_rules(scheme.mask()) < 2 || extent.rows == 1 || extent.cols == 1) return;
    // Only these two continue a plane as a plane.
    if (options.boundaries.x != Boundary::extrapolate && options.boundaries.x != Boundary::none)
      return;
    const Refiner<double> refiner(scheme, extent, options);
    const Grid<double> fine = refiner(test::plane<double>(extent, 40, 3, -7).view());
    const AxisPlacement x = refiner.x().placement();
    const AxisPlacement y = refiner.y().placement();
    for (Index r = 0; r < fine.rows(); ++r)
      for (Index c = 0; c < fine.cols(); ++c)
        ASSERT_NEAR(fine(r, c),
                    40 + 3 * (y.first + static_cast<double>(r) * y.spacing) -
                        7 * (x.first + static_cast<double>(c) * x.spacing),
                    1e-11)
            << scheme.text() << " " << to_string(options.boundaries.x);
  });
}

TEST(catalogue_laws, interpolatory_schemes_keep_samples_bit_for_bit) {
  int checked = 0;
  for_all([&](const Scheme& scheme, const RefineOptions& options, Extent extent) {
    if (!is_interpolatory(scheme.mask()) || options.alignment != Alignment::nodes) return;
    const Refiner<double> refiner(scheme, extent, options);
    const Grid<double> input = test::random_heights(extent);
    const Grid<double> fine = refiner(input.view());
    for (Index r = 0; r < extent.rows; ++r) {
      for (Index c = 0; c < extent.cols; ++c) {
        const Rational row = (r - refiner.y().first_position()) / refiner.y().spacing();
        const Rational col = (c - refiner.x().first_position()) / refiner.x().spacing();
        if (row < 0 || col < 0 || row >= fine.rows() || col >= fine.cols()) continue;
        ASSERT_TRUE(is_integer(row) && is_integer(col)) << scheme.text();
        ASSERT_EQ(fine(static_cast<Index>(floor(row)), static_cast<Index>(floor(col))), input(r, c))
            << scheme.text();
        ++checked;
      }
    }
  });
  EXPECT_GT(checked, 1000);
}

TEST(catalogue_laws, polynomials_up_to_the_reproduction_degree_are_reproduced) {
  for (const Scheme& scheme : test::sample_schemes()) {
    const int degree = reproduction_degree(scheme.mask());
    RefineOptions options;
    options.boundaries = {Boundary::none, Boundary::none};
    const AxisPlan plan(scheme.mask(), 40, {1, Boundary::none, Alignment::nodes, {}, {}});
    const auto value = [&](double x, int power) { return std::pow((x - 20) / 10, power); };
    const auto worst_error = [&](int power) {
      Grid<double> line({40, 1});
      for (Index r = 0; r < 40; ++r) line(r, 0) = value(static_cast<double>(r), power);
      const Grid<double> fine = Refiner<double>(AxisPlan::identity(1), plan)(line.view());
      const AxisPlacement at = plan.placement();
      double worst = 0;
      for (Index r = 0; r < fine.rows(); ++r)
        worst = std::max(
            worst,
            std::abs(fine(r, 0) - value(at.first + static_cast<double>(r) * at.spacing, power)));
      return worst;
    };
    for (int power = 0; power <= degree; ++power)
      EXPECT_LT(worst_error(power), 1e-11) << scheme.text() << " degree " << power;
    EXPECT_GT(worst_error(degree + 1), 1e-9) << scheme.text() << " claims too little";
  }
}

TEST(catalogue_laws, one_level_leaves_the_range_of_its_input_by_no_more_than_the_overshoot) {
  for (const Scheme& scheme : test::sample_schemes()) {
    Grid<double> line({64, 1});
    std::mt19937 random(3);
    for (double& v : line.samples()) v = static_cast<double>(random() % 2);
    const AxisPlan plan(scheme.mask(), 64, {1, Boundary::clamp, Alignment::nodes, {}, {}});
    const Grid<double> fine = Refiner<double>(AxisPlan::identity(1), plan)(line.view());
    const double bound = to_double(overshoot(scheme.mask()));
    for (double v : fine.samples()) {
      EXPECT_LE(v, 1 + bound + 1e-14) << scheme.text();
      EXPECT_GE(v, -bound - 1e-14) << scheme.text();
    }
  }
}

}  // namespace
}  // namespace arete
