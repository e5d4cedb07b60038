// SPDX-License-Identifier: MIT
// The fast ways through a grid, row by row and in blocks of lines, against the plain one, axis by
// axis: every bit.
#include "arete/reverse/grid_reverse_local.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "arete/reverse/row_filter.h"
#include "support/fields.h"
#include "support/schemes.h"

namespace arete {
namespace {

template <class T>
Lines<T> columns(Grid<T>& grid) {
  return {grid.samples().data(), grid.rows(), grid.cols(), grid.cols()};
}

// Rows as lines of their own.
Grid<double> turned(const Grid<double>& grid) {
  Grid<double> result({grid.cols(), grid.rows()});
  for (Index r = 0; r < grid.rows(); ++r)
    for (Index c = 0; c < grid.cols(); ++c) result(c, r) = grid(r, c);
  return result;
}

struct Halves {
  Grid<double> low;
  Grid<double> high;
};

Halves along_columns(const AxisReverse<double>& axis, Grid<double> fine) {
  Halves halves{Grid<double>({axis.coarse_count(), fine.cols()}),
                Grid<double>({axis.detail_count(), fine.cols()})};
  axis.analyse(columns(fine), columns(halves.low), columns(halves.high));
  return halves;
}

Halves along_rows(const AxisReverse<double>& axis, const Grid<double>& fine) {
  const Halves halves = along_columns(axis, turned(fine));
  return {turned(halves.low), turned(halves.high)};
}

struct Parts {
  Grid<double> coarse;
  std::vector<GridDetails<double>> details;
};

using Steps = std::vector<GridStepAxes<double>>;

// The axes of several levels, finest first.
Steps steps_of(const Mask& mask, Extent extent, Boundary boundary, ReverseMode mode, int levels) {
  Steps steps;
  for (int level = 0; level < levels; ++level) {
    steps.push_back({AxisReverse<double>(mask, extent.rows, boundary, mode),
                     AxisReverse<double>(mask, extent.cols, boundary, mode)});
    extent = {steps.back().y.coarse_count(), steps.back().x.coarse_count()};
  }
  return steps;
}

Parts parts_for(const Steps& steps) {
  Parts parts;
  for (const auto& [y, x] : steps) {
    parts.details.push_back({Grid<double>({y.coarse_count(), x.detail_count()}),
                             Grid<double>({y.detail_count(), x.coarse_count()}),
                             Grid<double>({y.detail_count(), x.detail_count()})});
    parts.coarse = Grid<double>({y.coarse_count(), x.coarse_count()});
  }
  return parts;
}

// The plain way: every axis of every level by itself.
Parts apart(const Steps& steps, Grid<double> fine) {
  Parts parts;
  for (const auto& [y, x] : steps) {
    const Halves down = along_columns(y, fine);
    Halves upper = along_rows(x, down.low);
    Halves lower = along_rows(x, down.high);
    parts.details.push_back({std::move(upper.high), std::move(lower.low), std::move(lower.high)});
    fine = std::move(upper.low);
  }
  parts.coarse = std::move(fine);
  return parts;
}

Grid<double> together(const Steps& steps, const Parts& parts) {
  Grid<double> coarse = parts.coarse;
  for (std::size_t k = steps.size(); k-- > 0;) {
    const auto& [y, x] = steps[k];
    Grid<double> low({x.fine_count(), y.coarse_count()});
    Grid<double> high({x.fine_count(), y.detail_count()});
    Grid<double> cc = turned(coarse), cd = turned(parts.details[k].cd);
    Grid<double> dc = turned(parts.details[k].dc), dd = turned(parts.details[k].dd);
    x.synthesise(columns(cc), columns(cd), columns(low));
    x.synthesise(columns(dc), columns(dd), columns(high));
    Grid<double> low_rows = turned(low), high_rows = turned(high);
    coarse = Grid<double>({y.fine_count(), x.fine_count()});
    y.synthesise(columns(low_rows), columns(high_rows), columns(coarse));
  }
  return coarse;
}

void expect_same(const Parts& actual, const Parts& expected, const std::string& what) {
  EXPECT_EQ(actual.coarse.samples(), expected.coarse.samples()) << what;
  for (std::size_t k = 0; k < expected.details.size(); ++k)
    for (std::size_t block = 0; block < 3; ++block)
      EXPECT_EQ(actual.details[k].blocks()[block]->samples(),
                expected.details[k].blocks()[block]->samples())
          << what << ", level " << k << ", block " << block;
}

struct Case {
  Boundary boundary;
  Extent extent;
  int levels;
};

template <class Work>
void for_cases(const Scheme& scheme, Work&& work) {
  for (const Boundary boundary : {Boundary::extrapolate, Boundary::clamp, Boundary::periodic})
    for (const Extent extent : {Extent{1, 1}, {1, 9}, {7, 1}, {2, 3}, {64, 128}, {81, 27}})
      for (const int levels : {1, 3})
        work(Case{boundary, extent, levels},
             scheme.text() + " " + std::string(to_string(boundary)) + " " +
                 std::to_string(extent.rows) + " x " + std::to_string(extent.cols) + ", " +
                 std::to_string(levels));
}

bool has_local_filters(const Scheme& scheme) {
  return local_rule(scheme.mask()) != LocalRule::none && scheme.name() != "two-parameter";
}

TEST(reverse_grid_rows, equal_the_axes_one_after_the_other_to_the_last_bit) {
  int compared = 0;
  for (const Scheme& scheme : test::sample_schemes()) {
    if (!has_local_filters(scheme)) continue;
    for_cases(scheme, [&](const Case& one, const std::string& what) {
      const Steps steps =
          steps_of(scheme.mask(), one.extent, one.boundary, ReverseMode::local, one.levels);
      if (!all_local(steps)) return;
      const Grid<double> fine = test::random_heights(one.extent);
      const Parts expected = apart(steps, fine);
      for (const int threads : {1, 3}) {
        Parts actual = parts_for(steps);
        decompose_by_rows(steps, fine.view(), actual.coarse, actual.details, threads);
        expect_same(actual, expected, what);
        Grid<double> again(one.extent);
        reconstruct_by_rows<double>(steps, actual.coarse, actual.details, again, threads);
        EXPECT_EQ(again.samples(), together(steps, expected).samples()) << what;
        ++compared;
      }
    });
  }
  EXPECT_GT(compared, 300);
}

TEST(reverse_grid_rows, are_left_alone_where_an_axis_is_padded_or_solved) {
  const Mask mask = parse_scheme("chaikin").mask();
  const auto local = [&](Extent extent, Boundary boundary, ReverseMode mode) {
    return all_local(steps_of(mask, extent, boundary, mode, 1));
  };
  EXPECT_TRUE(local({8, 8}, Boundary::periodic, ReverseMode::local));
  EXPECT_FALSE(local({8, 9}, Boundary::periodic, ReverseMode::local));
  EXPECT_FALSE(local({9, 8}, Boundary::periodic, ReverseMode::local));
  EXPECT_FALSE(local({8, 8}, Boundary::periodic, ReverseMode::least_squares));
}

TEST(reverse_grid_lines, equal_the_axes_one_after_the_other_to_the_last_bit) {
  const auto compare = [](const Scheme& scheme, ReverseMode mode) {
    for_cases(scheme, [&](const Case& one, const std::string& what) {
      const Steps steps = steps_of(scheme.mask(), one.extent, one.boundary, mode, one.levels);
      const Grid<double> fine = test::random_heights(one.extent);
      const Parts expected = apart(steps, fine);
      for (const int threads : {1, 3}) {
        Parts actual = parts_for(steps);
        Grid<double> before = fine;
        for (std::size_t k = 0; k < steps.size(); ++k) {
          Grid<double> coarse({steps[k].y.coarse_count(), steps[k].x.coarse_count()});
          analyse_step<double>(steps[k], before.view(), coarse, actual.details[k], threads);
          before = std::move(coarse);
        }
        actual.coarse = before;
        expect_same(actual, expected, what);
        for (std::size_t k = steps.size(); k-- > 0;)
          before = synthesise_step<double>(steps[k], before, actual.details[k], threads);
        EXPECT_EQ(before.samples(), together(steps, expected).samples()) << what;
      }
    });
  };
  for (const Scheme& scheme : test::sample_schemes()) {
    compare(scheme, ReverseMode::least_squares);
    if (has_local_filters(scheme)) compare(scheme, ReverseMode::local);
  }
}

TEST(row_cache, makes_a_row_once_while_it_is_kept) {
  RowCache<double> cache(3, 1);
  int made = 0;
  const auto row = [&](Index i) {
    return *cache.row(i, [&](double* out) {
      ++made;
      out[0] = static_cast<double>(10 * i);
    });
  };
  for (const Index i : {0, 1, 2, 1, 0, 2}) EXPECT_EQ(row(i), 10.0 * static_cast<double>(i));
  EXPECT_EQ(made, 3);
  EXPECT_EQ(row(3), 30);  // in the place of 1
  EXPECT_EQ(row(0), 0);
  EXPECT_EQ(row(2), 20);
  EXPECT_EQ(made, 4);
  EXPECT_EQ(row(1), 10);
  EXPECT_EQ(made, 5);
}

}  // namespace
}  // namespace arete
