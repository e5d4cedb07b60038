// SPDX-License-Identifier: MIT
// A rectangle of a result, computed from its window of the input alone, equals the same rectangle
// of the whole to the last bit.
#include "arete/refine/axis_window.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "arete/analysis/limit_stencil.h"
#include "arete/refine/refiner.h"
#include "support/fields.h"
#include "support/schemes.h"

namespace arete {
namespace {

constexpr Boundary every_boundary[]{Boundary::extrapolate, Boundary::clamp, Boundary::reflect,
                                    Boundary::periodic, Boundary::none};

// The samples of a window and nothing else; whatever else were read would be out of bounds.
Grid<double> cut_out(const Grid<double>& input, const GridWindow& window) {
  Grid<double> part(window.extent());
  for (Index r = 0; r < part.rows(); ++r)
    for (Index c = 0; c < part.cols(); ++c)
      part(r, c) =
          input(continued(Boundary::periodic, window.y.samples.first + r, input.rows()).near,
                continued(Boundary::periodic, window.x.samples.first + c, input.cols()).near);
  return part;
}

Index differing(const Grid<double>& part, const Grid<double>& whole, Index row, Index col) {
  Index count = 0;
  for (Index r = 0; r < part.rows(); ++r)
    for (Index c = 0; c < part.cols(); ++c)
      if (std::memcmp(&part(r, c), &whole(row + r, col + c), sizeof(double)) != 0) ++count;
  return count;
}

IndexRange random_run(std::mt19937& random, Index count) {
  const auto a = static_cast<Index>(random() % static_cast<unsigned>(count));
  const auto b = static_cast<Index>(random() % static_cast<unsigned>(count));
  return {std::min(a, b), std::max(a, b)};
}

// Random rectangles of one refinement; `shrink` leaves out that many samples of the halo.
Index differing_in_pieces(const AxisPlan& x, const AxisPlan& y, const Grid<double>& input,
                          std::mt19937& random, int pieces) {
  const Refiner<double> whole_refiner(x, y);
  const Grid<double> whole = whole_refiner(input.view());
  Index count = 0;
  for (int i = 0; i < pieces; ++i) {
    const IndexRange rows = random_run(random, whole.rows());
    const IndexRange cols = random_run(random, whole.cols());
    const GridWindow w = grid_window(x, y, rows, cols);
    const Grid<double> held = cut_out(input, w);
    const Refiner<double> refiner(w.x.plan, w.y.plan);
    EXPECT_EQ(refiner.output(), (Extent{rows.count(), cols.count()}));
    count += differing(refiner(held.view()), whole, rows.first, cols.first);
  }
  return count;
}

class PiecesTest : public ::testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(axis_window, PiecesTest, ::testing::Bool(), [](const auto& info) {
  return info.param ? "with_missing_samples" : "complete";
});

TEST_P(PiecesTest, any_rectangle_from_its_window_equals_the_whole_to_the_last_bit) {
  std::mt19937 random(5);
  const auto schemes = test::sample_schemes();
  int combinations = 0;
  for (std::size_t s = 0; s < schemes.size(); ++s) {
    const Scheme& other = schemes[(s + 7) % schemes.size()];
    for (Boundary boundary : every_boundary) {
      for (Alignment alignment : {Alignment::nodes, Alignment::cells}) {
        for (int levels : {0, 1, 3}) {
          if (levels > 1 && (schemes[s].mask().arity() > 2 || other.mask().arity() > 2)) levels = 2;
          if (levels > 1 && schemes[s].mask().arity() + other.mask().arity() > 6) levels = 1;
          Grid<double> input = test::random_heights({23, 31}, static_cast<unsigned>(s));
          if (GetParam())
            for (int hole = 0; hole < 12; ++hole)
              input.samples()[random() % input.samples().size()] = NAN;
          const Boundary along_y = boundary == Boundary::extrapolate ? Boundary::reflect : boundary;
          try {
            const AxisPlan x(schemes[s].mask(), 31, {levels, boundary, alignment, {}, {}});
            const AxisPlan y(other.mask(), 23, {levels, along_y, alignment, {}, {}});
            EXPECT_EQ(differing_in_pieces(x, y, input, random, 4), 0)
                << schemes[s].text() << " x " << other.text() << ", " << to_string(boundary) << ", "
                << levels << " levels";
            ++combinations;
          } catch (const InvalidField&) {
            EXPECT_EQ(boundary, Boundary::none) << schemes[s].text();
          }
        }
      }
    }
  }
  EXPECT_GT(combinations, 700);
}

TEST(axis_window, limits_and_tiny_axes_too) {
  std::mt19937 random(6);
  const Scheme scheme = parse_scheme("b-spline:degree=3");
  const Stencil limit = *limit_stencil(scheme.mask());
  for (Boundary boundary : every_boundary) {
    for (Extent extent : {Extent{1, 9}, Extent{9, 1}, Extent{2, 2}, Extent{1, 1}, Extent{3, 40}}) {
      const Grid<double> input = test::random_heights(extent);
      for (int levels : {0, 2, 4}) {
        try {
          const AxisOptions options{levels, boundary, Alignment::nodes, limit, {}};
          const AxisPlan x(scheme.mask(), extent.cols, options);
          const AxisPlan y(scheme.mask(), extent.rows, options);
          EXPECT_EQ(differing_in_pieces(x, y, input, random, 4), 0) << to_string(boundary);
        } catch (const InvalidField&) {
          EXPECT_EQ(boundary, Boundary::none);
        }
      }
    }
  }
}

TEST(axis_window, the_window_is_small_when_the_piece_is) {
  const Scheme scheme = parse_scheme("four-point");
  const AxisPlan plan(scheme.mask(), 1000, {6, Boundary::extrapolate, Alignment::nodes, {}, {}});
  const AxisWindow middle = window(plan, {32000, 32063}, plan.reach());
  EXPECT_LE(middle.samples.count(), 2 + 6 + 2 * (2 * plan.reach() + 2));
  EXPECT_LE(middle.samples.first, 500 - 2);
  EXPECT_GE(middle.samples.last, 501 + 2);
}

TEST(axis_window, a_periodic_window_crosses_the_seam_and_a_host_is_asked_for_all) {
  const Scheme scheme = parse_scheme("b-spline:degree=3");
  const AxisPlan plan(scheme.mask(), 40, {1, Boundary::periodic, Alignment::nodes, {}, {}});
  EXPECT_LT(window(plan, {0, 1}, plan.reach()).samples.first, 0);
  EXPECT_EQ(window(plan, {0, 1}, plan.reach()).real_samples(40), (IndexRange{0, 39}));
  const AxisWindow inside = window(plan, {40, 41}, plan.reach());
  EXPECT_EQ(inside.real_samples(40), inside.samples);
}

// The test above would mean nothing if the halo were not needed.
TEST(axis_window, without_the_halo_of_the_stencils_pieces_differ) {
  const Scheme scheme = parse_scheme("four-point");
  const AxisOptions options{3, Boundary::extrapolate, Alignment::nodes, {}, {}};
  const AxisPlan plan(scheme.mask(), 40, options);
  const Grid<double> input = test::random_heights({40, 40});
  const Grid<double> whole = Refiner<double>(plan, plan)(input.view());
  // The cells [10, 11] and their corners only, as a bilinear scheme would need.
  const IndexRange outputs{80, 88};
  const IndexRange corners{10, 11};
  Grid<double> held({2, 2});
  for (Index r = 0; r < 2; ++r)
    for (Index c = 0; c < 2; ++c) held(r, c) = input(10 + r, 10 + c);
  const AxisPlan part = AxisPlan(scheme.mask(), 2, options);
  const Grid<double> wrong = Refiner<double>(part, part)(held.view());
  EXPECT_GT(differing(wrong, whole, outputs.first, outputs.first), 40) << corners.count();
}

TEST(axis_window, results_that_do_not_exist_are_refused) {
  const AxisPlan plan = AxisPlan::identity(5);
  EXPECT_THROW((void)window(plan, {0, 5}, 0), InvalidField);
  EXPECT_THROW((void)window(plan, {-1, 2}, 0), InvalidField);
  EXPECT_THROW((void)window(plan, {3, 2}, 0), InvalidField);
}

}  // namespace
}  // namespace arete
