// SPDX-License-Identifier: MIT
// The named matrix pairs against the oracle records, exactly.
#include "arete/fractal/pairs.h"

#include <gtest/gtest.h>

#include "arete/algebra/characteristic_polynomial.h"
#include "arete/fractal/ifs.h"
#include "arete/fractal/spectrum.h"
#include "arete/fractal/tensor.h"
#include "support.h"

namespace arete {
namespace {

using nlohmann::json;
using test::exact;
using test::exact_list;
using test::exact_matrix;
using test::highest_first;
using test::ternary_and_reverse_records;
using Rationals = std::vector<Rational>;

Rationals sorted(Rationals values) {
  std::sort(values.begin(), values.end());
  return values;
}

void expect_spectrum(const Matrix<Rational>& a, const json& eigenvalues, const std::string& id) {
  const auto spectrum = rational_spectrum(a);
  ASSERT_TRUE(spectrum.has_value()) << id;
  EXPECT_EQ(sorted(*spectrum), sorted(exact_list(eigenvalues))) << id;
}

TEST(fractal_pairs, corner_cutting_matrices_and_their_spectra) {
  for (const json& record : ternary_and_reverse_records("r.LR_uv")) {
    const std::string id = record.at("id");
    const json& expect = record.at("expect");
    const Rational u = exact(record.at("input").at("u"));
    const Rational v = exact(record.at("input").at("v"));
    const auto pair = corner_cutting_pair(u, v);
    EXPECT_EQ(pair.left, exact_matrix(expect.at("L"))) << id;
    EXPECT_EQ(pair.right, exact_matrix(expect.at("R"))) << id;
    EXPECT_EQ(highest_first(characteristic_polynomial(pair.left)),
              exact_list(expect.at("charpoly_L")))
        << id;
    EXPECT_EQ(highest_first(characteristic_polynomial(pair.right)),
              exact_list(expect.at("charpoly_R")))
        << id;
    expect_spectrum(pair.left, expect.at("eigenvalues_L"), id);
    expect_spectrum(pair.right, expect.at("eigenvalues_R"), id);
    EXPECT_TRUE(is_stochastic(pair.left) && is_stochastic(pair.right)) << id;
  }
}

TEST(fractal_pairs, corner_cutting_spectra_are_1_1uv_u_and_1_1uv_v) {
  const Rational u(2, 7);
  const Rational v(1, 5);
  const auto pair = corner_cutting_pair(u, v);
  EXPECT_EQ(sorted(rational_spectrum(pair.left).value()), sorted({1, 1 - u - v, u}));
  EXPECT_EQ(sorted(rational_spectrum(pair.right).value()), sorted({1, 1 - u - v, v}));
}

TEST(fractal_pairs, bezier_of_any_degree) {
  for (const json& record : ternary_and_reverse_records("r.bezier_LR")) {
    const std::string id = record.at("id");
    const auto pair = bezier_pair<Rational>(record.at("input").at("degree").get<int>());
    EXPECT_EQ(pair.left, exact_matrix(record.at("expect").at("L"))) << id;
    EXPECT_EQ(pair.right, exact_matrix(record.at("expect").at("R"))) << id;
    expect_spectrum(pair.left, record.at("expect").at("eigenvalues"), id);
    expect_spectrum(pair.right, record.at("expect").at("eigenvalues"), id);
  }
  EXPECT_EQ(bezier_pair<Rational>(0).left, Matrix<Rational>::identity(1));
}

// De Casteljau: the points between which the halves meet come out of repeated averaging.
TEST(fractal_pairs, bezier_reproduces_de_casteljau) {
  for (int degree = 1; degree <= 7; ++degree) {
    const auto points = test::some_points(degree + 1);
    const auto pair = bezier_pair<Rational>(degree);
    const Matrix<Rational> left = pair.left * points;
    const Matrix<Rational> right = pair.right * points;
    Matrix<Rational> level = points;
    for (int step = 0; step <= degree; ++step) {
      for (int c = 0; c < 2; ++c) {
        EXPECT_EQ(left(step, c), level(0, c));
        EXPECT_EQ(right(degree - step, c), level(degree - step, c));
      }
      for (int i = 0; i + step < degree; ++i)
        for (int c = 0; c < 2; ++c) level(i, c) = (level(i, c) + level(i + 1, c)) / 2;
    }
  }
}

TEST(fractal_pairs, the_printed_perturbed_pair_is_not_affine_and_the_corrected_one_is) {
  const auto pair = perturbed_bezier_pair<Rational>();
  for (const json& record : ternary_and_reverse_records("r.perturbed")) {
    const json& expect = record.at("expect");
    if (record.at("id") == "r.perturbed/printed_row_sums") {
      MatrixPair<Rational> printed = pair;
      printed.left(3, 2) = printed.right(0, 2) = Rational(51, 100);
      EXPECT_EQ(row_sums(printed.left), exact_list(expect.at("row_sums_L")));
      EXPECT_EQ(row_sums(printed.right), exact_list(expect.at("row_sums_R")));
      EXPECT_THROW(check_maps<Rational>(printed), InvalidScheme);
      EXPECT_THROW(Ifs<Rational>(printed, test::some_points(4)), InvalidScheme);
    } else if (record.at("id") == "r.perturbed/corrected") {
      EXPECT_EQ(row_sums(pair.left), exact_list(expect.at("row_sums")));
      EXPECT_EQ(row_sums(pair.right), exact_list(expect.at("row_sums")));
      EXPECT_EQ(highest_first(characteristic_polynomial(pair.left)),
                exact_list(expect.at("charpoly_L")));
      EXPECT_EQ(highest_first(characteristic_polynomial(pair.right)),
                exact_list(expect.at("charpoly_R")));
      expect_spectrum(pair.left, expect.at("eigenvalues_L"), "L");
      expect_spectrum(pair.right, expect.at("eigenvalues_R"), "R");
    } else {
      const Ifs<Rational> ifs(pair, exact_matrix(record.at("input").at("control")));
      EXPECT_EQ(ifs.points(record.at("input").at("depth").get<int>()),
                exact_matrix(expect.at("points")));
    }
  }
}

TEST(fractal_pairs, cubic_spline_pair_of_any_length) {
  for (const json& record : ternary_and_reverse_records("r.spline_matrices")) {
    const json& expect = record.at("expect");
    const auto pair = cubic_spline_pair<Rational>(record.at("input").at("n").get<int>());
    EXPECT_EQ(pair.left, exact_matrix(expect.at("L"))) << record.at("id");
    EXPECT_EQ(pair.right, exact_matrix(expect.at("R"))) << record.at("id");
    EXPECT_EQ(highest_first(characteristic_polynomial(pair.left)),
              exact_list(expect.at("charpoly_L")));
  }
  // Two points: the segment.
  EXPECT_EQ(cubic_spline_pair<Rational>(1), bezier_pair<Rational>(1));
}

TEST(fractal_pairs, tensor_patches_and_their_spectra) {
  for (const json& record : ternary_and_reverse_records("r.tensor_spectrum")) {
    const MatrixSet<Rational> pair =
        corner_cutting_pair(exact(record.at("input").at("u")), exact(record.at("input").at("v")));
    const auto patch = tensor_product(pair, pair);
    ASSERT_EQ(patch.arity(), 4);
    for (const auto& [name, index] : {std::pair{"B1", 0}, {"B2", 1}, {"B4", 3}})
      expect_spectrum(patch[index], record.at("expect").at(name), record.at("id"));
  }
}

TEST(fractal_pairs, tensor_patches_cut_a_net_along_both_directions) {
  for (const json& record : ternary_and_reverse_records("r.tensor_apply")) {
    const MatrixSet<Rational> pair = test::named_pair(record.at("input").at("scheme"));
    const auto patch = tensor_product(pair, pair);
    Matrix<Rational> net(patch.size(), 1);
    const Rationals values = exact_list(record.at("input").at("net_index_i*n+j"));
    for (int i = 0; i < net.rows(); ++i) net(i, 0) = values[static_cast<std::size_t>(i)];
    for (const auto& [name, index] : {std::pair{"B1", 0}, {"B2", 1}, {"B3", 2}, {"B4", 3}}) {
      const Matrix<Rational> cut = patch[index] * net;
      const Rationals expected = exact_list(record.at("expect").at(name));
      for (int i = 0; i < net.rows(); ++i)
        EXPECT_EQ(cut(i, 0), expected[static_cast<std::size_t>(i)]) << record.at("id") << name;
    }
  }
}

TEST(fractal_spectrum, is_refused_where_an_eigenvalue_is_not_rational) {
  EXPECT_EQ(rational_spectrum(matrix_of_rows<Rational>({{0, 2}, {1, 0}})), std::nullopt);
  EXPECT_EQ(rational_spectrum(matrix_of_rows<Rational>({{0, -1}, {1, 0}})), std::nullopt);
  EXPECT_EQ(rational_spectrum(matrix_of_rows<Rational>({{Rational(22, 7)}})),
            (Rationals{Rational(22, 7)}));
  EXPECT_EQ(rational_spectrum(Matrix<Rational>(3, 3)), (Rationals{0, 0, 0}));
}

}  // namespace
}  // namespace arete
