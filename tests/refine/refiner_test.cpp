// SPDX-License-Identifier: MIT
#include "arete/refine/refiner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "arete/analysis/limit_stencil.h"
#include "arete/refine/reference.h"
#include "support/fields.h"
#include "support/schemes.h"

namespace arete {
namespace {

template <class T>
bool same_bits(const Grid<T>& a, const Grid<T>& b) {
  return a.extent() == b.extent() &&
         std::memcmp(a.samples().data(), b.samples().data(), a.samples().size() * sizeof(T)) == 0;
}

template <class T>
Table<T> to_table(const Grid<T>& grid) {
  Table<T> table;
  for (Index r = 0; r < grid.rows(); ++r)
    table.emplace_back(grid.row(r), grid.row(r) + grid.cols());
  return table;
}

constexpr Boundary every_boundary[]{Boundary::extrapolate, Boundary::clamp, Boundary::reflect,
                                    Boundary::periodic, Boundary::none};

template <class T>
class RefinerTest : public ::testing::Test {};
using Numbers = ::testing::Types<float, double>;
TYPED_TEST_SUITE(RefinerTest, Numbers);

TYPED_TEST(RefinerTest, equals_the_plain_reference_to_the_last_bit) {
  using T = TypeParam;
  const auto schemes = test::sample_schemes();
  int combinations = 0;
  for (std::size_t s = 0; s < schemes.size(); ++s) {
    const int levels = schemes[s].mask().arity() > 3 ? 1 : 2;
    for (Boundary boundary : every_boundary) {
      for (Alignment alignment : {Alignment::nodes, Alignment::cells}) {
        for (Extent extent :
             {Extent{1, 9}, Extent{2, 2}, Extent{7, 11}, Extent{13, 8}, Extent{6, 131}}) {
          RefineOptions options;
          options.levels = levels;
          options.boundaries = {boundary, Boundary::extrapolate};
          options.alignment = alignment;
          // The same scheme along y, or another one of the same or another arity.
          const Scheme& other = schemes[extent.cols < 12 ? (s + 5) % schemes.size() : s];
          if (boundary == Boundary::none && extent.cols < 9) continue;
          try {
            const Refiner<T> refiner(schemes[s], other, extent, options);
            const Grid<T> input = test::random_heights<T>(extent);
            const Table<T> expected = refine_reference(refiner.x(), refiner.y(), to_table(input));
            EXPECT_EQ(to_table(refiner(input.view())), expected)
                << schemes[s].text() << " " << to_string(boundary);
            ++combinations;
          } catch (const InvalidField&) {
            EXPECT_EQ(boundary, Boundary::none) << schemes[s].text();
          }
        }
      }
    }
  }
  EXPECT_GT(combinations, 1150);
}

TYPED_TEST(RefinerTest, a_filter_without_weights_gives_zeros) {
  using T = TypeParam;
  RefineOptions options;
  options.levels = 1;
  options.final_y = Stencil{0, {}};
  const Grid<T> input = test::random_heights<T>({9, 40});
  const Grid<T> result = refine(input.view(), parse_scheme("gentle"), options);
  for (const T v : result.samples()) EXPECT_EQ(v, T(0));
}

TYPED_TEST(RefinerTest, any_cut_into_bands_and_any_thread_count_give_the_same_bits) {
  using T = TypeParam;
  Grid<T> input = test::random_heights<T>({37, 29});
  for (Index hole : {5, 200, 201, 230, 700}) input.samples()[static_cast<std::size_t>(hole)] = NAN;
  for (const char* name : {"gentle", "chaikin", "ternary-two-step", "b-spline:degree=5"}) {
    for (Boundary boundary : {Boundary::extrapolate, Boundary::periodic, Boundary::reflect}) {
      RefineOptions options;
      options.levels = 3;
      options.boundaries = {boundary, boundary};
      const Scheme scheme = parse_scheme(name);
      const Grid<T> whole = refine(input, scheme, options);
      for (int threads : {2, 3, 7}) {
        options.threads = threads;
        EXPECT_TRUE(same_bits(refine(input, scheme, options), whole)) << name << threads;
      }
      options.threads = 1;
      const Refiner<T> refiner(scheme, input.extent(), options);
      for (Index height : {1, 2, 7, 64, 100}) {
        Grid<T> cut(refiner.output());
        for (Index first = 0; first < cut.rows(); first += height) {
          const Index rows = std::min(height, cut.rows() - first);
          refiner.refine_rows(GridSource<T>(input.view()), first,
                              GridView<T>(cut.row(first), {rows, cut.cols()}));
        }
        EXPECT_TRUE(same_bits(cut, whole)) << name << " bands of " << height;
      }
    }
  }
}

// Wider than a strip and larger than the cache; with and without holes; rows that begin anywhere.
TYPED_TEST(RefinerTest, large_results_in_any_memory_and_tile_by_tile_are_the_same) {
  using T = TypeParam;
  for (const char* name : {"gentle", "four-point", "ternary-four-point", "ternary-two-step-9"}) {
    const Scheme scheme = parse_scheme(name);
    Grid<T> input = test::random_heights<T>({40, 450});
    input(7, 300) = NAN;
    RefineOptions options;
    options.levels = scheme.mask().arity() == 2 ? 3 : scheme.mask().arity() == 3 ? 2 : 1;
    const Refiner<T> refiner(scheme, input.extent(), options);
    const GridSource<T> source(input.view());
    const Extent size = refiner.output();

    Grid<T> small_bands(size);
    for (Index first = 0; first < size.rows; first += 16)
      refiner.refine_rows(
          source, first,
          GridView<T>(small_bands.row(first), {std::min<Index>(16, size.rows - first), size.cols}));

    // Gaps of 3 samples, which must stay as they are.
    constexpr Index gap = 3;
    std::vector<T> memory(static_cast<std::size_t>(1 + size.rows * (size.cols + gap)), T(-7777));
    const GridView<T> wide(memory.data() + 1, size, size.cols + gap);
    refiner.refine_rows(source, 0, wide);

    Grid<T> tiles(size, T(-1));
    refiner.for_each_tile(source, {0, size.rows - 1},
                          [&](Index row, Index col, GridView<const T> tile) {
                            for (Index r = 0; r < tile.rows(); ++r)
                              std::copy_n(tile.row(r), tile.cols(), &tiles(row + r, col));
                          });
    EXPECT_TRUE(same_bits(tiles, small_bands)) << name;
    const Plane<T> plane = refiner.plane(input.view());
    for (Index r = 0; r < size.rows; ++r) {
      ASSERT_EQ(std::memcmp(wide.row(r), small_bands.row(r),
                            static_cast<std::size_t>(size.cols) * sizeof(T)),
                0)
          << name << " row " << r;
      ASSERT_EQ(std::memcmp(plane.row(r), small_bands.row(r),
                            static_cast<std::size_t>(size.cols) * sizeof(T)),
                0)
          << name << " row " << r;
      ASSERT_EQ(reinterpret_cast<std::uintptr_t>(plane.row(r)) % Plane<T>::alignment, 0u);
      for (Index g = 0; g < gap; ++g) ASSERT_EQ(wide.row(r)[size.cols + g], T(-7777));
    }
  }
}

TEST(refiner, the_order_of_rows_and_columns_does_not_matter) {
  const Grid<double> input = test::random_heights({9, 12});
  Grid<double> turned({12, 9});
  for (Index r = 0; r < 9; ++r)
    for (Index c = 0; c < 12; ++c) turned(c, r) = input(r, c);
  for (const Scheme& scheme : test::sample_schemes()) {
    RefineOptions options;
    options.levels = scheme.mask().arity() > 3 ? 1 : 3;
    const Grid<double> a = refine(input, scheme, options);
    const Grid<double> b = refine(turned, scheme, options);
    ASSERT_EQ(a.rows(), b.cols());
    double scale = 0;
    for (double v : a.samples()) scale = std::max(scale, std::abs(v));
    for (Index r = 0; r < a.rows(); ++r)
      for (Index c = 0; c < a.cols(); ++c)
        EXPECT_NEAR(a(r, c), b(c, r), 1e-12 * scale) << scheme.text();
  }
}

TEST(refiner, two_steps_are_one_step_of_the_squared_scheme) {
  const Grid<double> input = test::dyadic_heights({8, 7});
  RefineOptions options;
  options.levels = 2;
  const Grid<double> two = refine(input, parse_scheme("ternary-two-step:b=1/10"), options);
  options.levels = 1;
  const Grid<double> one = refine(input, parse_scheme("ternary-two-step-9:b=1/10"), options);
  ASSERT_EQ(two.extent(), one.extent());
  for (std::size_t i = 0; i < one.samples().size(); ++i)
    EXPECT_NEAR(two.samples()[i], one.samples()[i], 1e-11);
}

TEST(refiner, level_zero_is_the_input) {
  const Grid<double> input = test::random_heights({5, 6});
  RefineOptions options;
  options.levels = 0;
  for (const Scheme& scheme : test::sample_schemes())
    EXPECT_TRUE(same_bits(refine(input, scheme, options), input)) << scheme.text();
}

TEST(refiner, a_view_with_gaps_between_rows_is_read_right) {
  const Grid<double> wide = test::random_heights({6, 20});
  Grid<double> narrow({6, 7});
  for (Index r = 0; r < 6; ++r)
    for (Index c = 0; c < 7; ++c) narrow(r, c) = wide(r, c + 3);
  const GridView<const double> view(wide.row(0) + 3, {6, 7}, 20);
  EXPECT_TRUE(same_bits(refine<double>(view, parse_scheme("gentle")),
                        refine(narrow, parse_scheme("gentle"))));
}

TEST(refiner, limit_stencils_of_an_approximating_scheme_leave_the_limit_in_place) {
  // Limit positions at level 1 and at level 3 are values of one and the same function.
  const Scheme scheme = parse_scheme("b-spline:degree=3");
  const Stencil limit = *limit_stencil(scheme.mask());
  const Grid<double> input = test::dyadic_heights({9, 9});
  RefineOptions options;
  options.final_x = limit;
  options.final_y = limit;
  options.levels = 1;
  const Grid<double> coarse = refine(input, scheme, options);
  options.levels = 3;
  const Grid<double> fine = refine(input, scheme, options);
  for (Index r = 0; r < coarse.rows(); ++r)
    for (Index c = 0; c < coarse.cols(); ++c) EXPECT_NEAR(coarse(r, c), fine(4 * r, 4 * c), 1e-11);
}

TEST(refiner, sizes_that_do_not_fit_are_refused) {
  const Refiner<double> refiner(parse_scheme("gentle"), {5, 5}, {});
  const Grid<double> other({4, 5});
  EXPECT_THROW((void)refiner(other.view()), InvalidField);
  Grid<double> band({3, 8});
  const Grid<double> input({5, 5});
  EXPECT_THROW(refiner.refine_rows(GridSource<double>(input.view()), 0, band.view()), InvalidField);
}

}  // namespace
}  // namespace arete
