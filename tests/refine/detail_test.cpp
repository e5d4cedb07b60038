// SPDX-License-Identifier: MIT
#include "arete/refine/detail.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "arete/refine/reference.h"
#include "arete/refine/refiner.h"
#include "support/fields.h"
#include "support/schemes.h"

namespace arete {
namespace {

template <class T>
bool same_bits(const Grid<T>& a, const Grid<T>& b) {
  return a.extent() == b.extent() &&
         std::memcmp(a.samples().data(), b.samples().data(), a.samples().size() * sizeof(T)) == 0;
}

RefineOptions options_with(Detail detail, int levels, Boundary boundary = Boundary::extrapolate) {
  RefineOptions options;
  options.levels = levels;
  options.boundaries = {boundary, boundary};
  options.detail = detail;
  return options;
}

template <class T>
class DetailTest : public ::testing::Test {};
using Numbers = ::testing::Types<float, double>;
TYPED_TEST_SUITE(DetailTest, Numbers);

TYPED_TEST(DetailTest, equals_the_plain_reference_to_the_last_bit) {
  using T = TypeParam;
  const Detail detail{0.7, 0.2, 42};
  const auto schemes = test::sample_schemes();
  for (std::size_t s = 0; s < schemes.size(); ++s) {
    for (Boundary boundary : {Boundary::extrapolate, Boundary::periodic, Boundary::reflect}) {
      for (Extent extent : {Extent{1, 9}, Extent{5, 7}}) {
        for (bool keep : {true, false}) {
          RefineOptions options =
              options_with(detail, schemes[s].mask().arity() > 2 ? 1 : 2, boundary);
          options.detail->keep_samples = keep;
          const Refiner<T> refiner(schemes[s], schemes[(s + 5) % schemes.size()], extent, options);
          const Grid<T> input = test::random_heights<T>(extent);
          Table<T> heights;
          for (Index r = 0; r < extent.rows; ++r)
            heights.emplace_back(input.row(r), input.row(r) + extent.cols);
          const Displacement<T> displacement(*options.detail, refiner.x(), refiner.y());
          const IndexRange all{0, extent.rows - 1};
          const GridSource<T> source(input.view());
          const InputWindow<T> window(source, {-2, extent.rows + 1}, options.boundaries, 0);
          const LocalRelief<T> relief(window, options.boundaries, all);
          const Table<T> expected = refine_reference(
              refiner.x(), refiner.y(), heights, [&](std::size_t rule, Table<T>& level) {
                if (!displacement.displaces(rule)) return;
                const Index row = refiner.y().ranges()[rule + 1].first;
                const Index col = refiner.x().ranges()[rule + 1].first;
                for (std::size_t r = 0; r < level.size(); ++r)
                  for (std::size_t c = 0; c < level[r].size(); ++c)
                    level[r][c] =
                        level[r][c] + displacement.at(rule, row + static_cast<Index>(r),
                                                      col + static_cast<Index>(c), relief);
              });
          const Grid<T> result = refiner(input.view());
          for (Index r = 0; r < result.rows(); ++r)
            for (Index c = 0; c < result.cols(); ++c)
              ASSERT_EQ(result(r, c),
                        expected[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)])
                  << schemes[s].text() << " " << to_string(boundary) << " " << r << " " << c;
        }
      }
    }
  }
}

TYPED_TEST(DetailTest, any_cut_into_bands_and_any_thread_count_give_the_same_bits) {
  using T = TypeParam;
  Grid<T> input = test::random_heights<T>({37, 29});
  for (Index hole : {5, 200, 201, 230, 700}) input.samples()[static_cast<std::size_t>(hole)] = NAN;
  for (const char* name : {"gentle", "chaikin", "ternary-two-step", "three-point"}) {
    for (Boundary boundary : {Boundary::extrapolate, Boundary::periodic, Boundary::none}) {
      RefineOptions options = options_with({0.3, 0.4, 9}, 3, boundary);
      const Scheme scheme = parse_scheme(name);
      const Grid<T> whole = refine(input, scheme, options);
      for (int threads : {2, 5}) {
        options.threads = threads;
        EXPECT_TRUE(same_bits(refine(input, scheme, options), whole)) << name << threads;
      }
      options.threads = 1;
      const Refiner<T> refiner(scheme, input.extent(), options);
      for (Index height : {1, 7, 100}) {
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

TYPED_TEST(DetailTest, relief_0_is_no_detail_and_flat_land_stays_flat) {
  using T = TypeParam;
  const Grid<T> input = test::random_heights<T>({9, 8});
  const Scheme scheme = parse_scheme("gentle");
  RefineOptions plain;
  plain.levels = 3;
  EXPECT_TRUE(
      same_bits(refine(input, scheme, options_with({0.5, 0, 1}, 3)), refine(input, scheme, plain)));
  const Grid<T> flat({9, 8}, T(250));
  EXPECT_TRUE(
      same_bits(refine(flat, scheme, options_with({0.5, 1, 1}, 3)), refine(flat, scheme, plain)));
}

TEST(detail, interpolatory_schemes_pass_through_the_input_on_request) {
  const Grid<double> input = test::random_heights({9, 8});
  for (const char* name :
       {"four-point", "dubuc-deslauriers:points=6", "b-spline:degree=1", "three-point"}) {
    const Scheme scheme = parse_scheme(name);
    RefineOptions options = options_with({0.4, 0.5, 3}, 3);
    for (bool keep : {true, false}) {
      options.detail->keep_samples = keep;
      const Refiner<double> refiner(scheme, input.extent(), options);
      const Grid<double> fine = refiner(input.view());
      const Rational first_x = refiner.x().first_position();
      const Rational first_y = refiner.y().first_position();
      ASSERT_TRUE(is_integer(first_x * 8) && is_integer(first_y * 8)) << name;
      const auto place = [](Index i, const Rational& first) {
        return static_cast<Index>(floor((i - first) * 8));
      };
      int kept = 0;
      int moved = 0;
      for (Index r = 1; r < 8; ++r)
        for (Index c = 1; c < 7; ++c) {
          const bool same = fine(place(r, first_y), place(c, first_x)) == input(r, c);
          ++(same ? kept : moved);
        }
      EXPECT_EQ(keep ? moved : kept, 0) << name;
    }
  }
}

TEST(detail, is_added_where_the_terrain_has_relief_and_grows_with_it) {
  // West a plain at sea level, east hills; every height doubled.
  Grid<double> input = test::dyadic_heights({16, 32});
  for (Index r = 0; r < 16; ++r)
    for (Index c = 0; c < 16; ++c) input(r, c) = 0;
  Grid<double> doubled = input;
  for (double& v : doubled.samples()) v *= 2;
  const Scheme scheme = parse_scheme("b-spline:degree=1");
  const RefineOptions options = options_with({0.5, 0.25, 4}, 3);
  const Grid<double> fine = refine(input, scheme, options);
  const Grid<double> fine_doubled = refine(doubled, scheme, options);
  for (std::size_t i = 0; i < fine.samples().size(); ++i)
    EXPECT_EQ(fine_doubled.samples()[i], 2 * fine.samples()[i]);
  for (Index r = 0; r < fine.rows(); ++r)
    for (Index c = 0; c <= 14 * 8; ++c) EXPECT_EQ(fine(r, c), 0);
}

// With a linear scheme the displacement of a level is where its new samples depart from the mean of
// their neighbours; later levels leave them in place.
TEST(detail, amplitude_falls_by_two_to_the_minus_roughness_a_level) {
  const Scheme scheme = parse_scheme("b-spline:degree=1");
  // Rows alternate by 8, so the local relief is 8 everywhere.
  Grid<double> input({65, 65});
  for (Index r = 0; r < 65; ++r)
    for (Index c = 0; c < 65; ++c) input(r, c) = r % 2 == 0 ? 0 : 8;
  const double roughness = 0.6;
  const auto fine = refine(input, scheme, options_with({roughness, 0.5, 8}, 5));
  std::vector<double> deviation;
  for (int level = 1; level <= 3; ++level) {
    const Index step = Index{1} << (5 - level);
    double sum = 0;
    Index count = 0;
    // New samples on old rows, between two old samples of that row.
    for (Index r = 0; r < fine.rows(); r += 2 * step)
      for (Index c = step; c + step < fine.cols(); c += 2 * step, ++count)
        sum += std::pow(fine(r, c) - (fine(r, c - step) + fine(r, c + step)) / 2, 2);
    deviation.push_back(std::sqrt(sum / static_cast<double>(count)));
  }
  EXPECT_NEAR(deviation[0], 0.5 * 8, 0.5 * 8 * 0.05);
  for (std::size_t i = 1; i < deviation.size(); ++i)
    EXPECT_NEAR(deviation[i] / deviation[i - 1], std::exp2(-roughness), 0.04);
}

TEST(detail, holes_neither_grow_nor_leak) {
  Grid<double> input = test::random_heights({20, 20});
  const Scheme scheme = parse_scheme("gentle");
  Grid<double> holed = input;
  holed(8, 9) = NAN;
  Grid<double> other = holed;
  other(8, 9) = -INFINITY;
  const RefineOptions options = options_with({0.5, 0.2, 2}, 2);
  const Grid<double> fine = refine(holed, scheme, options);
  EXPECT_TRUE(same_bits(refine(other, scheme, options), fine));
  RefineOptions plain;
  plain.levels = 2;
  const Grid<double> smooth = refine(holed, scheme, plain);
  for (std::size_t i = 0; i < fine.samples().size(); ++i)
    EXPECT_EQ(std::isnan(fine.samples()[i]), std::isnan(smooth.samples()[i]));
}

TEST(detail, local_relief_is_the_range_of_the_valid_neighbours) {
  Grid<double> input = test::random_heights({6, 7});
  input(2, 3) = NAN;
  input(0, 0) = NAN;
  const GridSource<double> source(input.view());
  for (Boundary boundary : {Boundary::clamp, Boundary::periodic}) {
    const Boundaries boundaries{boundary, boundary};
    const InputWindow<double> window(source, {-1, 6}, boundaries, 1);
    const LocalRelief<double> relief(window, boundaries, {0, 5});
    for (Index r = 0; r < 6; ++r)
      for (Index c = 0; c < 7; ++c) {
        double low = INFINITY;
        double high = -INFINITY;
        for (Index i = r - 1; i <= r + 1; ++i)
          for (Index j = c - 1; j <= c + 1; ++j) {
            const bool inside = i >= 0 && i < 6 && j >= 0 && j < 7;
            if (!inside && boundary != Boundary::periodic) continue;
            const double v = input((i + 6) % 6, (j + 7) % 7);
            if (std::isnan(v)) continue;
            low = std::min(low, v);
            high = std::max(high, v);
          }
        EXPECT_EQ(relief.row(r)[c], high - low) << r << " " << c;
      }
    EXPECT_EQ(relief.row(3)[7], relief.row(3)[boundary == Boundary::periodic ? 0 : 6]);
  }
}

TEST(detail, numbers_out_of_range_are_refused) {
  const Grid<double> input = test::random_heights({5, 5});
  const Scheme scheme = parse_scheme("gentle");
  for (const Detail& bad : {Detail{-0.1, 0.1}, Detail{2.1, 0.1}, Detail{NAN, 0.1},
                            Detail{0.5, -0.1}, Detail{0.5, INFINITY}, Detail{0.5, NAN}})
    EXPECT_THROW((void)refine(input, scheme, options_with(bad, 1)), InvalidField);
}

}  // namespace
}  // namespace arete
