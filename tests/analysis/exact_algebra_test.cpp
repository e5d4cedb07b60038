// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "analysis/oracle_scheme.h"
#include "arete/algebra/linear_solve.h"
#include "arete/algebra/real_roots.h"
#include "arete/algebra/schur_cohn.h"
#include "arete/analysis/difference_theorems.h"
#include "arete/analysis/local_matrices.h"

namespace arete {
namespace {

using test::exact_list;

std::vector<Rational> descending(std::vector<Rational> ascending) {
  std::reverse(ascending.begin(), ascending.end());
  return ascending;
}

TEST(SolveUnique, SaysWhenThereIsNoOrNoSingleSolution) {
  Matrix<Rational> a(2, 2);
  a(0, 0) = 1, a(0, 1) = 2, a(1, 0) = 2, a(1, 1) = 4;
  EXPECT_FALSE(solve_unique(a, {1, 2}).has_value());  // a line of solutions
  EXPECT_FALSE(solve_unique(a, {1, 3}).has_value());  // none
  EXPECT_EQ(exact_rank(a), 1);
  a(1, 1) = 5;
  EXPECT_EQ(solve_unique(a, {1, 3}), (std::vector<Rational>{-1, 1}));
  EXPECT_EQ(exact_rank(a), 2);
}

TEST(SchurCohn, IsExactOnTheUnitCircle) {
  const Rational almost = 1 - parse_rational("1e-60");
  EXPECT_TRUE(is_schur_stable(monic_polynomial({almost, -almost, 0, Rational(1) / 3})));
  EXPECT_FALSE(is_schur_stable(monic_polynomial({1, 0, Rational(1) / 3})));
  EXPECT_FALSE(is_schur_stable(monic_polynomial({-1, Rational(1) / 2})));
  EXPECT_FALSE(is_schur_stable({1, 0, 1}));      // +-i
  EXPECT_TRUE(is_schur_stable({almost, 0, 1}));  // just inside
  EXPECT_FALSE(is_schur_stable(monic_polynomial({2, Rational(1) / 2})));
  EXPECT_TRUE(is_schur_stable({5}));
}

TEST(SchurCohn, AgreesWithKnownRootsOfHighDegree) {
  std::vector<Rational> roots;
  for (int i = 1; i <= 12; ++i) roots.push_back(Rational(i % 2 == 0 ? i : -i) / 13);
  EXPECT_TRUE(is_schur_stable(monic_polynomial(roots)));
  roots[3] = Rational(14) / 13;
  EXPECT_FALSE(is_schur_stable(monic_polynomial(roots)));
}

TEST(RealRoots, AreCountedOnceIncludingTheEnds) {
  EXPECT_EQ(distinct_real_roots(monic_polynomial({-2, 0, 0, 0, 1, 2, 3}), -2, 2), 4);
  EXPECT_EQ(distinct_real_roots(monic_polynomial({-2, -2, 2, 2}), -2, 2), 2);
  EXPECT_EQ(distinct_real_roots({1, 0, 1}, -2, 2), 0);
  EXPECT_EQ(distinct_real_roots({7}, -2, 2), 0);
}

TEST(LocalMatrices, MeetTheTernaryOracle) {
  for (const auto& record : test::ternary_and_reverse_records("t.transition")) {
    SCOPED_TRACE(record.at("id").get<std::string>());
    const LocalMatrices local =
        local_matrices(3, factored(test::ternary_mask(record.at("input"))).rest);
    ASSERT_EQ(local.size, 4);
    const auto& expect = record.at("expect");
    const char* const names[] = {"D7", "D6", "D5"};  // digits 0, 1, 2
    for (int digit = 0; digit < 3; ++digit)
      for (int i = 0; i < 4; ++i) {
        const auto row = exact_list(expect.at(names[digit]).at(static_cast<std::size_t>(i)));
        for (int j = 0; j < 4; ++j)
          EXPECT_EQ(local.matrices[static_cast<std::size_t>(digit)](i, j),
                    row[static_cast<std::size_t>(j)]);
      }
    EXPECT_EQ(descending(characteristic_polynomial(local.matrices[2])),
              exact_list(expect.at("charpoly_D5")));
    EXPECT_EQ(descending(characteristic_polynomial(word_product(local, {0, 2}))),
              exact_list(expect.at("charpoly_D5D7")));
  }
}

TEST(CentralMatrix, HasTheEigenvaluesOfTheLemmas) {
  for (const auto& record : test::parametric_records("p1.lemma")) {
    SCOPED_TRACE(record.at("id").get<std::string>());
    const auto coefficients = exact_list(record.at("input").at("coef_ascending"));
    const int m = record.at("input").at("m").get<int>();
    const Matrix<Rational> matrix = central_matrix(coefficients, m);
    EXPECT_EQ(matrix.rows(), record.at("expect").at("size").get<int>());
    auto eigenvalues = exact_list(record.at("expect").at("eigenvalues"));
    std::sort(eigenvalues.begin(), eigenvalues.end());
    EXPECT_EQ(lemma_eigenvalues(coefficients, m), eigenvalues);
    const auto characteristic = characteristic_polynomial(matrix);
    EXPECT_EQ(descending(characteristic),
              exact_list(record.at("expect").at("charpoly_descending")));
    EXPECT_EQ(characteristic, monic_polynomial(eigenvalues));
  }
}

// The appendix of Shen and Huang, from the central matrix of D_{k+1} to that of D_k, in the paper's
// order of rows and columns: add all columns to the last, take out its factor, subtract from each
// row the next, multiply by a triangle of ones. Its last column has to be (0, ..., 0, 1)^T; as
// printed, all ones, the last column of the product is not.
TEST(CentralMatrix, TheMultiplierOfTheAppendixNeedsAnotherLastColumn) {
  const Rational a = Rational(2) / 7, b = Rational(-3) / 5, c = Rational(9) / 11;
  const Rational lambda = Rational(4) / 13;
  const auto shifted_matrix = [&](int m) {
    const auto d =
        LaurentPolynomial<Rational>(0, {c, b, a}) * power(smoothing_factor<Rational>(2), m);
    Matrix<Rational> matrix(m + 3, m + 3);
    for (int i = 0; i < m + 3; ++i)
      for (int j = 0; j < m + 3; ++j)
        matrix(i, j) = d[m + 2 + i - 2 * j] - (i == j ? lambda : Rational(0));
    return matrix;
  };
  for (int k = 1; k <= 3; ++k) {
    Matrix<Rational> work = shifted_matrix(k + 1);
    const int n = k + 4;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j + 1 < n; ++j) work(i, n - 1) += work(i, j);
    const Rational factor = (1 << k) * (a + b + c) - lambda;
    for (int i = 0; i < n; ++i) {
      ASSERT_EQ(work(i, n - 1), factor);
      work(i, n - 1) = 1;
    }
    for (int i = 0; i + 1 < n; ++i)
      for (int j = 0; j < n; ++j) work(i, j) -= work(i + 1, j);
    Matrix<Rational> corrected(n, n);
    for (int i = 0; i < n; ++i)
      for (int j = i; j < n; ++j) corrected(i, j) = j + 1 < n || i == j ? 1 : 0;
    Matrix<Rational> printed = corrected;
    for (int i = 0; i < n; ++i) printed(i, n - 1) = 1;

    const Matrix<Rational> right = work * corrected;
    const Matrix<Rational> smaller = shifted_matrix(k);
    for (int i = 0; i + 1 < n; ++i) {
      EXPECT_EQ(right(i, n - 1), 0);
      for (int j = 0; j + 1 < n; ++j) EXPECT_EQ(right(i, j), smaller(i, j));
    }
    EXPECT_EQ(right(n - 1, n - 1), 1);
    const Matrix<Rational> wrong = work * printed;
    EXPECT_EQ(wrong(n - 2, n - 1), c - lambda);
    EXPECT_NE(wrong(n - 1, n - 1), 1);
  }
}

}  // namespace
}  // namespace arete
