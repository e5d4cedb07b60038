// SPDX-License-Identifier: MIT
#include "arete/reverse/bezier_reverse.h"

#include <gtest/gtest.h>

#include "rational_grid.h"

namespace arete {
namespace {

template <class R>
Lines<R> lines_of(Grid<R>& grid) {
  return {grid.samples().data(), grid.rows(), grid.cols(), grid.cols()};
}

template <class R>
Grid<R> least_squares_coarse(int degree, Index pieces, Grid<R> fine) {
  Grid<R> coarse({degree * pieces + 1, fine.cols()});
  Grid<R> details({degree * pieces, fine.cols()});
  bezier_least_squares<R>(degree, pieces)
      .analyse(lines_of(fine), lines_of(coarse), lines_of(details));
  return coarse;
}

TEST(bezier_reverse, oracle_matrices_and_values) {
  for (const auto& record : test::ternary_and_reverse_records("r.reverse_bezier")) {
    const int degree = record.at("input").at("degree");
    const Grid<Rational> fine = test::exact_grid(record.at("input").at("fine"));
    const auto expected = test::exact_grid(record.at("expect").at("coarse"));
    test::expect_exact(least_squares_coarse(degree, 1, fine), expected, record.at("id"));
    test::expect_near(least_squares_coarse(degree, 1, test::to_double(fine)), expected,
                      record.at("id"));
    Grid<Rational> unit({2 * degree + 1, 2 * degree + 1});
    for (Index i = 0; i < unit.rows(); ++i) unit(i, i) = 1;
    test::expect_exact(least_squares_coarse(degree, 1, unit),
                       test::exact_grid(record.at("expect").at("ls_matrix")), record.at("id"));
  }
}

template <class Reverse>
Grid<Rational> analyse(const Reverse& reverse, Grid<Rational> fine, Grid<Rational>& details,
                       Index coarse_count) {
  Grid<Rational> coarse({coarse_count, fine.cols()});
  if constexpr (requires { reverse.analysis; }) {
    reverse.analysis.multiply(lines_of(fine), lines_of(coarse));
    reverse.detail.multiply(lines_of(fine), lines_of(coarse), lines_of(details));
  } else {
    reverse.analyse(lines_of(fine), lines_of(coarse), lines_of(details));
  }
  return coarse;
}

template <class Reverse>
void check_laws(const Reverse& reverse, int degree, Index pieces) {
  const std::string what = "degree " + std::to_string(degree) + ", " + std::to_string(pieces);
  const Index coarse_count = degree * pieces + 1;
  Grid<Rational> details({degree * pieces, 2});
  const auto any = test::random_integers<Rational>({2 * degree * pieces + 1, 2}, 3);
  Grid<Rational> coarse = analyse(reverse, any, details, coarse_count);
  Grid<Rational> back(any.extent());
  if constexpr (requires { reverse.synthesis; })
    reverse.synthesis.multiply(lines_of(coarse), lines_of(details), lines_of(back));
  else
    reverse.synthesise(lines_of(coarse), lines_of(details), lines_of(back));
  test::expect_exact(back, any, what);

  auto chain = test::random_integers<Rational>({coarse_count, 2}, 4);
  Grid<Rational> halves(any.extent());
  bezier_halving<Rational>(degree, pieces).multiply(lines_of(chain), lines_of(halves));
  test::expect_exact(analyse(reverse, halves, details, coarse_count), chain, what);
  for (const Rational& detail : details.samples()) EXPECT_EQ(detail, 0) << what;
}

TEST(bezier_reverse, identity_and_zero_details_for_chains) {
  for (const Index pieces : {1, 2, 5}) {
    for (const int degree : {1, 2, 3, 4, 7})
      check_laws(bezier_least_squares<Rational>(degree, pieces), degree, pieces);
    for (const int degree : {2, 3})
      check_laws(bezier_local<Rational>(degree, pieces), degree, pieces);
  }
  EXPECT_THROW((void)bezier_local<double>(4, 1), InvalidField);
  EXPECT_THROW((void)bezier_halving<double>(0, 1), InvalidField);
  EXPECT_THROW((void)bezier_least_squares<double>(2, 0), InvalidField);
}

TEST(bezier_reverse, halving_is_de_casteljau) {
  Grid<Rational> cubic({4, 1});
  cubic.samples() = {0, 8, 16, 64};
  Grid<Rational> halves({7, 1});
  bezier_halving<Rational>(3, 1).multiply(lines_of(cubic), lines_of(halves));
  EXPECT_EQ(halves.samples(), (std::vector<Rational>{0, 4, 8, 17, 26, 40, 64}));
}

}  // namespace
}  // namespace arete
