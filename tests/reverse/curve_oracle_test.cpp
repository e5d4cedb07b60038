// SPDX-License-Identifier: MIT
// Every record about reverse subdivision of curves: exactly over rationals, to 1e-12 in double.
#include <gtest/gtest.h>

#include "arete/reverse/curve_reverse.h"
#include "arete/reverse/local_filter.h"
#include "arete/scheme/catalogue.h"
#include "rational_grid.h"

namespace arete {
namespace {

using nlohmann::json;
using test::exact_grid;
using test::expect_exact;
using test::expect_near;

Scheme scheme_named(const std::string& name) {
  if (name == "chaikin") return parse_scheme("chaikin");
  if (name == "cubic") return parse_scheme("b-spline:degree=3");
  if (name == "fourpoint") return parse_scheme("four-point");
  return parse_scheme("ternary-two-step:" + name.substr(name.find('_') + 1));
}

void check(const json& record, const Scheme& scheme, ReverseMode mode, bool closed) {
  const std::string id = record.at("id");
  const CurveReverseOptions options{1, mode, closed, Boundary::extrapolate};
  const Grid<Rational> fine = exact_grid(record.at("input").at("fine"));
  const json& expect = record.at("expect");
  const auto parts = decompose<Rational>(fine.view(), scheme, options);
  expect_exact(parts.coarse, exact_grid(expect.at("coarse")), id);
  expect_exact(reconstruct(parts), fine, id);
  const auto rounded = decompose<double>(test::to_double(fine).view(), scheme, options);
  expect_near(rounded.coarse, exact_grid(expect.at("coarse")), id);
  expect_near(reconstruct(rounded), fine, id);
  if (expect.contains("details")) {
    expect_exact(parts.details.front(), exact_grid(expect.at("details")), id);
    expect_near(rounded.details.front(), exact_grid(expect.at("details")), id);
  }
  if (expect.contains("sum_squared_residual")) {
    auto smooth = parts;
    for (Rational& detail : smooth.details.front().samples()) detail = 0;
    const Grid<Rational> refined = reconstruct(smooth);
    Rational sum = 0;
    for (std::size_t i = 0; i < refined.samples().size(); ++i) {
      const Rational e = fine.samples()[i] - refined.samples()[i];
      sum += e * e;
    }
    EXPECT_EQ(sum, test::exact(expect.at("sum_squared_residual"))) << id;
  }
}

TEST(reverse_oracle, corner_cutting) {
  for (const json& record : test::ternary_and_reverse_records("r.reverse_corner")) {
    const json& input = record.at("input");
    check(record,
          make_scheme("corner-cutting",
                      {{"u", {test::exact(input.at("u"))}}, {"v", {test::exact(input.at("v"))}}}),
          ReverseMode::local, input.at("closed"));
  }
}

TEST(reverse_oracle, cubic_b_spline) {
  for (const json& record : test::ternary_and_reverse_records("r.reverse_cubic"))
    check(record, scheme_named("cubic"), ReverseMode::local, record.at("input").at("closed"));
}

TEST(reverse_oracle, four_point) {
  for (const json& record : test::ternary_and_reverse_records("r.reverse_fourpoint"))
    check(record, scheme_named("fourpoint"), ReverseMode::local, record.at("input").at("closed"));
}

TEST(reverse_oracle, closed_least_squares) {
  for (const json& record : test::ternary_and_reverse_records("r.reverse_ls"))
    check(record, scheme_named(record.at("input").at("scheme")), ReverseMode::least_squares, true);
}

// The records continue the coarse samples by ghosts of their own and keep more fine samples than
// the nodes, so the matrix is made for them.
template <class R>
Grid<R> open_least_squares(const json& input, const Grid<R>& fine) {
  const Index n = input.at("coarse_count");
  const auto weights = test::exact_list(input.at("extension_weights_of_p_-1"));
  const std::function<typename SparseRows<R>::Row(Index)> sample = [&](Index j) {
    typename SparseRows<R>::Row row;
    if (j >= 0 && j < n) return typename SparseRows<R>::Row{{j, R(1)}};
    for (std::size_t k = 0; k < weights.size(); ++k) {
      const Index step = static_cast<Index>(k) + 1;
      for (const auto& part : sample(j < 0 ? j + step : j - step))
        row.push_back({part.col, weights[k].template convert_to<R>() * part.weight});
    }
    return row;
  };
  const Index first = input.at("first_fine_index");
  const SparseRows<R> s = synthesis_rows<R>(scheme_named(input.at("scheme")).mask(), n,
                                            {first, first + fine.rows() - 1}, sample);
  Grid<R> coarse({n, 1});
  const Lines<R> result{coarse.row(0), n, 1, 1};
  NormalEquations<R>(s, s.transposed()).solve({fine.row(0), fine.rows(), 1, 1}, result);
  return coarse;
}

TEST(reverse_oracle, open_least_squares) {
  for (const json& record : test::ternary_and_reverse_records("r.reverse_ls_open")) {
    const Grid<Rational> fine = exact_grid(record.at("input").at("fine"));
    const Grid<Rational> expected = exact_grid(record.at("expect").at("coarse"));
    const std::string id = record.at("id");
    expect_exact(open_least_squares(record.at("input"), fine), expected, id);
    expect_near(open_least_squares(record.at("input"), test::to_double(fine)), expected, id);
  }
}

TEST(reverse_oracle, local_filters_of_windows) {
  for (const json& record : test::ternary_and_reverse_records("r.local_filter")) {
    const json& window = record.at("input").at("fine_window");
    const Stencil filter = local_filter(scheme_named(record.at("input").at("scheme")).mask(),
                                        {window[0].get<Index>(), window[1].get<Index>()});
    EXPECT_EQ(filter.first, window[0].get<int>()) << record.at("id");
    EXPECT_EQ(filter.weights, test::exact_list(record.at("expect").at("filter")))
        << record.at("id");
  }
  const Mask cubic = scheme_named("cubic").mask();
  EXPECT_THROW((void)local_filter(cubic, {0, 0}), InvalidScheme);
  EXPECT_THROW((void)local_filter(cubic, {5, 9}), InvalidScheme);
}

Grid<Rational> generated_contour(int n) {
  Grid<Rational> points({n, 2});
  const int h = n / 2;
  for (int i = 0; i < n; ++i) {
    points(i, 0) = 4 * std::abs(i - h) + (i * i) % 13;
    points(i, 1) = 4 * std::abs((i + h / 2) % n - h) + (3 * i) % 7;
  }
  return points;
}

TEST(reverse_oracle, contours) {
  for (const json& record : test::ternary_and_reverse_records("r.contour")) {
    const std::string id = record.at("id");
    const json& expect = record.at("expect");
    const Grid<Rational> fine = generated_contour(record.at("input").at("n"));
    const CurveReverseOptions options{record.at("input").at("levels"), ReverseMode::local, true,
                                      Boundary::extrapolate};
    const auto parts = decompose<Rational>(fine.view(), parse_scheme("chaikin"), options);
    EXPECT_EQ(parts.sizes, expect.at("sizes").get<std::vector<Index>>()) << id;
    expect_exact(parts.coarse, exact_grid(expect.at("coarse")), id);
    const auto sums = test::exact_list(expect.at("sum_of_squared_details_per_level"));
    ASSERT_EQ(sums.size(), parts.details.size());
    for (std::size_t level = 0; level < sums.size(); ++level) {
      Rational sum = 0;
      for (const Rational& d : parts.details[level].samples()) sum += d * d;
      EXPECT_EQ(sum, sums[level]) << id << ", level " << level;
    }
    expect_exact(reconstruct(parts), fine, id);
    const auto rounded =
        decompose<double>(test::to_double(fine).view(), parse_scheme("chaikin"), options);
    expect_near(rounded.coarse, exact_grid(expect.at("coarse")), id);
    expect_near(reconstruct(rounded), fine, id);
  }
}

TEST(reverse_oracle, contour_counts_of_the_paper) {
  for (const json& record : test::ternary_and_reverse_records("r.contour_counts")) {
    const auto wanted = record.at("expect").at("every_second_level").get<std::vector<Index>>();
    for (const ReverseMode mode : {ReverseMode::local, ReverseMode::least_squares}) {
      const auto parts =
          decompose<double>(test::to_double(generated_contour(record.at("input").at("n"))).view(),
                            parse_scheme("chaikin"), {6, mode, true, Boundary::extrapolate});
      for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_EQ(parts.sizes.at(2 * i), wanted[i]);
    }
  }
}

}  // namespace
}  // namespace arete
