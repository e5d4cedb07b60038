// SPDX-License-Identifier: MIT
// Missing samples: what they may and may not do.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "arete/refine/refiner.h"
#include "support/fields.h"
#include "support/schemes.h"

namespace arete {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Grid<double> with_holes(Grid<double> grid, double value = nan) {
  for (const auto& [r, c] :
       {std::pair<Index, Index>{3, 4}, {3, 5}, {4, 5}, {9, 0}, {0, 8}, {11, 12}, {6, 9}, {7, 8}})
    grid(r, c) = value;
  return grid;
}

// The documented rule, by brute force over closed cells.
bool cell_is_complete(const Grid<double>& input, Index i, Index j) {
  if (i < 0 || j < 0 || i + 1 >= input.rows() || j + 1 >= input.cols()) return false;
  return std::isfinite(input(i, j)) && std::isfinite(input(i + 1, j)) &&
         std::isfinite(input(i, j + 1)) && std::isfinite(input(i + 1, j + 1));
}

bool expected_valid(const Grid<double>& input, const Rational& y, const Rational& x) {
  for (Index i = 0; i + 1 < input.rows(); ++i)
    for (Index j = 0; j + 1 < input.cols(); ++j)
      if (y >= i && y <= i + 1 && x >= j && x <= j + 1 && cell_is_complete(input, i, j))
        return true;
  return false;
}

TEST(missing, a_result_is_valid_iff_its_input_cell_has_only_valid_corners) {
  const Grid<double> input = with_holes(test::random_heights({13, 14}));
  for (const Scheme& scheme : test::sample_schemes()) {
    RefineOptions options;
    options.levels = scheme.mask().arity() > 2 ? 1 : 2;
    const Refiner<double> refiner(scheme, input.extent(), options);
    const Grid<double> fine = refiner(input.view());
    for (Index r = 0; r < fine.rows(); ++r)
      for (Index c = 0; c < fine.cols(); ++c)
        ASSERT_EQ(std::isfinite(fine(r, c)),
                  expected_valid(input, refiner.y().first_position() + r * refiner.y().spacing(),
                                 refiner.x().first_position() + c * refiner.x().spacing()))
            << scheme.text() << " at " << r << ", " << c;
  }
}

TEST(missing, the_number_standing_for_nodata_has_no_influence) {
  const Grid<double> terrain = test::random_heights({13, 14});
  const Grid<double> a = with_holes(terrain, nan);
  const Grid<double> b = with_holes(terrain, std::numeric_limits<double>::infinity());
  const Grid<double> c = with_holes(terrain, -std::numeric_limits<double>::infinity());
  for (const Scheme& scheme : test::sample_schemes()) {
    RefineOptions options;
    options.levels = scheme.mask().arity() > 2 ? 1 : 2;
    const Grid<double> fine = refine(a, scheme, options);
    for (const Grid<double>& other : {refine(b, scheme, options), refine(c, scheme, options)})
      for (std::size_t i = 0; i < fine.samples().size(); ++i)
        EXPECT_TRUE(fine.samples()[i] == other.samples()[i] ||
                    (std::isnan(fine.samples()[i]) && std::isnan(other.samples()[i])));
  }
}

TEST(missing, a_plane_beside_holes_stays_exactly_that_plane) {
  // Dyadic slopes and weights: every operation is exact, so equality is meant literally.
  const Grid<double> input = with_holes(test::plane<double>({13, 14}, 96, 12, -24));
  for (const char* name : {"four-point", "b-spline:degree=3", "b-spline:degree=5", "gentle",
                           "chaikin", "b-spline:degree=2", "dubuc-deslauriers:points=8",
                           "four-parameter:lambda=3/32,mu=1/32,nu=1/4,omega=1/32"}) {
    RefineOptions options;
    options.levels = 2;
    for (Alignment alignment : {Alignment::nodes, Alignment::cells}) {
      options.alignment = alignment;
      const Refiner<double> refiner(parse_scheme(name), input.extent(), options);
      const Grid<double> fine = refiner(input.view());
      Index valid = 0;
      for (Index r = 0; r < fine.rows(); ++r)
        for (Index c = 0; c < fine.cols(); ++c) {
          if (std::isnan(fine(r, c))) continue;
          ++valid;
          const Rational height = 96 +
                                  12 * (refiner.y().first_position() + r * refiner.y().spacing()) -
                                  24 * (refiner.x().first_position() + c * refiner.x().spacing());
          ASSERT_EQ(Rational(fine(r, c)), height) << name << " at " << r << ", " << c;
        }
      EXPECT_GT(valid, fine.rows() * fine.cols() / 2);
    }
  }
}

TEST(missing, holes_far_away_change_nothing) {
  const Grid<double> whole = test::random_heights({20, 20});
  Grid<double> holed = whole;
  holed(2, 2) = nan;
  for (const Scheme& scheme : test::sample_schemes()) {
    RefineOptions options;
    options.levels = 1;
    const Refiner<double> refiner(scheme, whole.extent(), options);
    const Grid<double> a = refiner(whole.view());
    const Grid<double> b = refiner(holed.view());
    for (Index r = a.rows() / 2; r < a.rows(); ++r)
      for (Index c = 0; c < a.cols(); ++c) EXPECT_EQ(a(r, c), b(r, c));
  }
}

TEST(missing, nothing_valid_gives_nothing_valid_and_isolated_samples_make_no_surface) {
  Grid<double> input({6, 6}, nan);
  const Scheme gentle = parse_scheme("gentle");
  const Grid<double> nothing = refine(input, gentle);
  for (double v : nothing.samples()) EXPECT_TRUE(std::isnan(v));
  input(2, 2) = 5;
  const Grid<double> isolated = refine(input, gentle);
  for (double v : isolated.samples()) EXPECT_TRUE(std::isnan(v));
  // One complete cell: exactly its closed square.
  input(2, 3) = input(3, 2) = input(3, 3) = 5;
  Index valid = 0;
  const Grid<double> one_cell = refine(input, gentle);
  for (double v : one_cell.samples()) {
    if (std::isnan(v)) continue;
    EXPECT_NEAR(v, 5, 1e-14);
    ++valid;
  }
  EXPECT_EQ(valid, 9);
}

TEST(missing, a_final_stencil_that_reads_from_afar_leaves_holes_where_they_are) {
  const Grid<double> input = with_holes(test::random_heights({13, 14}));
  for (const Boundary boundary : {Boundary::reflect, Boundary::clamp, Boundary::extrapolate}) {
    for (const Stencil& stencil : {Stencil{90, {Rational(1)}}, Stencil{18, {Rational(0)}},
                                   Stencil{6, {}}, Stencil{12, {Rational(1)}}}) {
      RefineOptions options;
      options.levels = 0;
      options.boundaries = {boundary, boundary};
      options.final_y = stencil;
      const Refiner<double> refiner(parse_scheme("b-spline:degree=3"), input.extent(), options);
      // Row by row: each needs input rows far from its own.
      Grid<double> row({1, refiner.output().cols});
      for (Index r = 0; r < refiner.output().rows; ++r) {
        refiner.refine_rows(GridSource<double>(input.view()), r, row.view());
        for (Index c = 0; c < row.cols(); ++c)
          ASSERT_EQ(std::isfinite(row(0, c)),
                    expected_valid(input, refiner.y().first_position() + r * refiner.y().spacing(),
                                   refiner.x().first_position() + c * refiner.x().spacing()))
              << static_cast<int>(boundary) << " " << stencil.first << " at " << r << ", " << c;
      }
    }
  }
}

TEST(missing, a_profile_of_one_row_is_cut_where_its_intervals_are_incomplete) {
  Grid<double> input({1, 7}, 3);
  input(0, 4) = nan;
  const Grid<double> fine = refine(input, parse_scheme("four-point"));
  ASSERT_EQ(fine.cols(), 13);
  for (Index c = 0; c < 13; ++c) EXPECT_EQ(std::isnan(fine(0, c)), c > 6 && c < 10) << c;
}

TEST(missing, holes_across_the_seam_of_a_closed_axis) {
  Grid<double> input({8, 8}, 1);
  input(3, 0) = nan;
  RefineOptions options;
  options.boundaries = {Boundary::periodic, Boundary::extrapolate};
  const Grid<double> fine = refine(input, parse_scheme("four-point"), options);
  // Columns 15 and 1 lie in the two cells beside the hole, 14 and 2 on their valid rims.
  EXPECT_TRUE(std::isnan(fine(6, 15)));
  EXPECT_TRUE(std::isnan(fine(6, 0)));
  EXPECT_TRUE(std::isnan(fine(6, 1)));
  EXPECT_EQ(fine(6, 14), 1);
  EXPECT_EQ(fine(6, 2), 1);
}

}  // namespace
}  // namespace arete
