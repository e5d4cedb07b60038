// SPDX-License-Identifier: MIT
// Reverse subdivision of grids, their holes, and the dropping of details.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "arete/refine/refiner.h"
#include "arete/reverse/threshold.h"
#include "rational_grid.h"
#include "support/fields.h"
#include "support/schemes.h"

namespace arete {
namespace {

using test::relative_difference;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

GridReverseOptions options_with(int levels, ReverseMode mode,
                                Boundary boundary = Boundary::extrapolate, int threads = 1) {
  return {levels, mode, {boundary, boundary}, threads};
}

double largest(const Grid<double>& grid) {
  double value = 0;
  for (const double v : grid.samples()) value = std::max(value, std::abs(v));
  return value;
}

TEST(reverse_grid, oracle_blocks) {
  for (const auto& record : test::ternary_and_reverse_records("r.reverse_grid")) {
    const Grid<double> fine = test::to_double(test::exact_grid(record.at("input").at("fine")));
    ASSERT_EQ(record.at("input").at("scheme"), "chaikin");
    const auto parts =
        decompose_grid<double>(fine.view(), parse_scheme("chaikin"),
                               options_with(1, ReverseMode::local, Boundary::periodic));
    const auto expected = [&](const char* block) {
      return test::to_double(test::exact_grid(record.at("expect").at(block)));
    };
    // Dyadic numbers and filters: equality is meant literally.
    EXPECT_EQ(parts.coarse.samples(), expected("cc").samples());
    EXPECT_EQ(parts.details[0].cd.samples(), expected("cd").samples());
    EXPECT_EQ(parts.details[0].dc.samples(), expected("dc").samples());
    EXPECT_EQ(parts.details[0].dd.samples(), expected("dd").samples());
  }
}

TEST(reverse_grid, identity_for_all_schemes_and_many_extents) {
  for (const Scheme& scheme : test::sample_schemes()) {
    for (const ReverseMode mode : {ReverseMode::local, ReverseMode::least_squares}) {
      if (mode == ReverseMode::local &&
          (local_rule(scheme.mask()) == LocalRule::none || scheme.name() == "two-parameter"))
        continue;
      const bool wild = scheme.name() == "difference" ||
                        scheme.text() == "three-parameter:a=1/5,c=-1/3,m=2,raise=1";
      for (const Boundary boundary : {Boundary::extrapolate, Boundary::periodic}) {
        for (const Extent extent : {Extent{1, 1}, {1, 9}, {7, 1}, {2, 3}, {65, 130}, {31, 64}}) {
          const Grid<double> fine = test::random_heights(extent);
          const auto options = options_with(3, mode, boundary);
          const auto parts = decompose_grid<double>(fine.view(), scheme, options);
          EXPECT_LE(relative_difference(reconstruct_grid(parts, extent, scheme, options, 3), fine),
                    wild ? 1e-6 : 1e-12)
              << scheme.text() << " " << to_string(mode) << " " << to_string(boundary) << " "
              << extent.rows << " x " << extent.cols;
          Index numbers = parts.coarse.rows() * parts.coarse.cols();
          for (const auto& level : parts.details)
            for (const auto* block : level.blocks())
              numbers += static_cast<Index>(block->samples().size());
          if (boundary != Boundary::periodic) {
            EXPECT_EQ(numbers, extent.rows * extent.cols);
          }
        }
      }
    }
  }
}

TEST(reverse_grid, a_refined_grid_comes_back_with_zero_details_at_its_place) {
  for (const char* name : {"chaikin", "four-point", "b-spline:degree=3", "gentle", "three-point",
                           "ternary-two-step", "b-spline:degree=5"}) {
    const Scheme scheme = parse_scheme(name);
    for (const ReverseMode mode : {ReverseMode::local, ReverseMode::least_squares}) {
      if (mode == ReverseMode::local && local_rule(scheme.mask()) == LocalRule::none) continue;
      const Grid<double> coarse = test::random_heights({9, 14});
      RefineOptions one;
      one.levels = 1;
      const Refiner<double> refiner(scheme, coarse.extent(), one);
      const Grid<double> fine = refiner(coarse.view());
      const auto options = options_with(1, mode);
      const auto parts = decompose_grid<double>(fine.view(), scheme, options);
      EXPECT_LE(relative_difference(parts.coarse, coarse), 1e-12) << name;
      for (const auto* block : parts.details[0].blocks()) EXPECT_LE(largest(*block), 1e-9) << name;

      const Georeference place{{400000, 30, 3, 5000000, -2, -30}, Registration::area};
      const Georeference there = refined(place, refiner);
      const GridPyramid pyramid(scheme.mask(), fine.extent(), options);
      const Georeference back = refined(there, pyramid.row_placement(1), pyramid.col_placement(1));
      for (std::size_t i = 0; i < 6; ++i)
        EXPECT_NEAR(back.affine[i], place.affine[i], 1e-8) << name << " " << i;
    }
  }
}

TEST(reverse_grid, threads_and_lanes_change_no_bit) {
  const Grid<double> fine = test::random_heights({150, 210});
  for (const char* name : {"chaikin", "gentle"}) {
    const Scheme scheme = parse_scheme(name);
    const auto one = options_with(3, ReverseMode::least_squares);
    const auto many = options_with(3, ReverseMode::least_squares, Boundary::extrapolate, 4);
    const auto a = decompose_grid<double>(fine.view(), scheme, one);
    const auto b = decompose_grid<double>(fine.view(), scheme, many);
    EXPECT_EQ(a.coarse.samples(), b.coarse.samples());
    for (std::size_t level = 0; level < 3; ++level)
      EXPECT_EQ(a.details[level].dd.samples(), b.details[level].dd.samples());
    EXPECT_EQ(reconstruct_grid(a, fine.extent(), scheme, one, 3).samples(),
              reconstruct_grid(b, fine.extent(), scheme, many, 3).samples());
    // A column of the grid is the curve of its own.
    Grid<double> column({150, 1});
    for (Index r = 0; r < 150; ++r) column(r, 0) = fine(r, 77);
    const AxisReverse<double> axis(scheme.mask(), 150, Boundary::extrapolate,
                                   ReverseMode::least_squares);
    std::vector<double> low(static_cast<std::size_t>(axis.coarse_count()));
    std::vector<double> high(static_cast<std::size_t>(axis.detail_count()));
    axis.analyse({column.row(0), 150, 1, 1}, {low.data(), axis.coarse_count(), 1, 1},
                 {high.data(), axis.detail_count(), 1, 1});
    Grid<double> wide({150, 100});
    for (Index r = 0; r < 150; ++r) wide(r, 99) = column(r, 0);
    Grid<double> wide_low({axis.coarse_count(), 100});
    Grid<double> wide_high({axis.detail_count(), 100});
    axis.analyse({wide.row(0), 150, 100, 100}, {wide_low.row(0), axis.coarse_count(), 100, 100},
                 {wide_high.row(0), axis.detail_count(), 100, 100});
    for (Index j = 0; j < axis.coarse_count(); ++j)
      EXPECT_EQ(wide_low(j, 99), low[static_cast<std::size_t>(j)]);
  }
}

TEST(reverse_grid, missing_samples_are_filled_from_their_rim) {
  Grid<double> grid({6, 7}, 5);
  for (Index r = 1; r < 5; ++r)
    for (Index c = 1; c < 6; ++c) grid(r, c) = nan;
  grid(0, 0) = std::numeric_limits<double>::infinity();
  const ValidSamples valid = fill_missing(grid.view());
  for (const double v : grid.samples()) EXPECT_EQ(v, 5);
  EXPECT_EQ(std::count(valid.begin(), valid.end(), 0), 21);
  EXPECT_EQ(valid[0], 0);
  EXPECT_EQ(valid[1], 1);
  Grid<double> nothing({2, 2}, nan);
  EXPECT_THROW((void)fill_missing(nothing.view()), InvalidField);
  Grid<double> whole({3, 3}, 1);
  EXPECT_TRUE(fill_missing(whole.view()).empty());
}

TEST(reverse_grid, coarse_samples_exist_where_their_nearest_fine_samples_do) {
  // Primal: the sample at the same place. Dual: the four around.
  ValidSamples valid(9 * 9, 1);
  valid[4 * 9 + 4] = 0;
  valid[0] = 0;
  const auto missing = [&](const char* name) {
    const GridPyramid pyramid(parse_scheme(name).mask(), {9, 9}, options_with(1, {}));
    const ValidSamples coarse = coarsened(valid, pyramid, 1);
    std::vector<Index> holes;
    for (std::size_t i = 0; i < coarse.size(); ++i)
      if (coarse[i] == 0) holes.push_back(static_cast<Index>(i));
    return holes;
  };
  EXPECT_EQ(missing("four-point"), (std::vector<Index>{0, 2 * 5 + 2}));
  // Chaikin on 9 samples: 5 coarse ones at -1/2, 3/2, 7/2, 11/2, 15/2.
  EXPECT_EQ(missing("chaikin"), (std::vector<Index>{0, 2 * 5 + 2}));
}

TEST(reverse_grid, dropping_details_loses_what_it_says) {
  Grid<double> fine({64, 64});
  for (Index r = 0; r < 64; ++r)
    for (Index c = 0; c < 64; ++c)
      fine(r, c) = 100 * std::sin(0.1 * static_cast<double>(r)) +
                   80 * std::cos(0.07 * static_cast<double>(c)) + (r == 30 && c == 31 ? 25 : 0);
  const Scheme scheme = parse_scheme("b-spline:degree=3");
  const auto options = options_with(3, ReverseMode::least_squares);
  const auto parts = decompose_grid<double>(fine.view(), scheme, options);
  const auto dropped_at = [&](double threshold) {
    auto dropped = parts;
    drop_details(dropped, threshold);
    return dropped;
  };
  const auto error_at = [&](double threshold) {
    return restore_error(reconstruct_grid(dropped_at(threshold), fine.extent(), scheme, options, 3),
                         fine.view(), {})
        .rmse;
  };
  EXPECT_LE(error_at(0), 1e-5);  // float32
  EXPECT_GT(error_at(5), error_at(0.5));
  EXPECT_LT(count_details(dropped_at(1)).kept, count_details(parts).kept / 10);
  EXPECT_EQ(count_details(parts).all, 64 * 64 - parts.coarse.rows() * parts.coarse.cols());
  for (const double target : {0.01, 0.1, 1.0}) {
    const double threshold = threshold_for_rmse(parts, fine.view(), {}, scheme, options, target);
    EXPECT_LE(error_at(threshold), target);
    EXPECT_GT(error_at(1.05 * threshold), 0.9 * target);
  }
  EXPECT_THROW((void)dropped_at(-1), InvalidField);
  EXPECT_THROW((void)dropped_at(nan), InvalidField);
  ValidSamples valid(64 * 64, 1);
  valid[30 * 64 + 31] = 0;
  Grid<double> off = fine;
  off(30, 31) += 1000;
  EXPECT_EQ(restore_error(off, fine.view(), valid).largest, 0);
  EXPECT_EQ(restore_error(off, fine.view(), {}).largest, 1000);
}

TEST(reverse_grid, parts_of_another_grid_are_refused) {
  const Grid<double> fine = test::random_heights({20, 21});
  const Scheme scheme = parse_scheme("chaikin");
  const auto options = options_with(2, ReverseMode::local);
  auto parts = decompose_grid<double>(fine.view(), scheme, options);
  EXPECT_THROW((void)reconstruct_grid(parts, {21, 20}, scheme, options, 2), InvalidField);
  EXPECT_THROW((void)reconstruct_grid(parts, fine.extent(), scheme, options, 3), InvalidField);
  parts.details[0].dc = Grid<double>({1, 1});
  EXPECT_THROW((void)reconstruct_grid(parts, fine.extent(), scheme, options, 2), InvalidField);
  EXPECT_THROW((void)decompose_grid<double>(Grid<double>({0, 3}).view(), scheme, options),
               InvalidField);
  EXPECT_THROW((void)decompose_grid<double>(fine.view(), scheme, options_with(-1, {})),
               InvalidField);
}

}  // namespace
}  // namespace arete
