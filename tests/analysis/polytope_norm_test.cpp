// SPDX-License-Identifier: MIT
#include "arete/analysis/polytope_norm.h"

#include <glpk.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace arete {
namespace {

using Points = std::vector<std::vector<double>>;

// The same linear program by GLPK: min sum (l+ + l-) with sum (l+ - l-) v = x.
double glpk_norm(const Points& points, const std::vector<double>& x) {
  const int n = static_cast<int>(x.size());
  const int count = static_cast<int>(points.size());
  glp_term_out(GLP_OFF);
  glp_prob* program = glp_create_prob();
  glp_set_obj_dir(program, GLP_MIN);
  glp_add_rows(program, n);
  for (int i = 0; i < n; ++i)
    glp_set_row_bnds(program, i + 1, GLP_FX, x[static_cast<std::size_t>(i)], 0);
  glp_add_cols(program, 2 * count);
  for (int k = 0; k < 2 * count; ++k) {
    glp_set_col_bnds(program, k + 1, GLP_LO, 0, 0);
    glp_set_obj_coef(program, k + 1, 1);
    std::vector<int> rows{0};
    std::vector<double> values{0};
    for (int i = 0; i < n; ++i) {
      rows.push_back(i + 1);
      values.push_back((k < count ? 1 : -1) *
                       points[static_cast<std::size_t>(k % count)][static_cast<std::size_t>(i)]);
    }
    glp_set_mat_col(program, k + 1, n, rows.data(), values.data());
  }
  glp_smcp options;
  glp_init_smcp(&options);
  options.tol_bnd = options.tol_dj = 1e-11;
  EXPECT_EQ(glp_simplex(program, &options), 0);
  EXPECT_EQ(glp_get_status(program), GLP_OPT);
  const double norm = glp_get_obj_val(program);
  glp_delete_prob(program);
  return norm;
}

PolytopeNorm made_of(const Points& points, int n) {
  PolytopeNorm norm(n);
  for (const auto& point : points) norm.add(point);
  return norm;
}

TEST(PolytopeNorm, IsTheOptimumThatGlpkFinds) {
  std::mt19937 random(5);
  std::normal_distribution<double> number;
  for (const int n : {1, 2, 3, 5, 8, 13, 20})
    for (int trial = 0; trial < 6; ++trial) {
      Points points;
      for (int k = 0; k < n + 4 * n * trial; ++k) {
        std::vector<double> point;
        for (int i = 0; i < n; ++i)
          // Every other trial on a coarse lattice, where bases are degenerate and ties abound.
          point.push_back(trial % 2 == 0 ? number(random) : std::round(2 * number(random)) / 4);
        if (k < n) point[static_cast<std::size_t>(k)] += 4;  // the first n span
        points.push_back(std::move(point));
      }
      PolytopeNorm norm = made_of(points, n);
      for (int query = 0; query < 8; ++query) {
        std::vector<double> x;
        for (int i = 0; i < n; ++i)
          x.push_back(query % 2 == 0 ? number(random) : std::round(number(random)));
        const auto found = norm.combine(x, 0);
        const double expected = glpk_norm(points, x);
        EXPECT_NEAR(found.norm, expected, 1e-9 * (1 + expected)) << n << " " << trial;
        // The combination gives x, and has that norm.
        double sum = 0;
        std::vector<double> made(x.size(), 0.0);
        for (std::size_t b = 0; b < found.points.size(); ++b) {
          sum += std::abs(found.weights[b]);
          const auto& v = points[static_cast<std::size_t>(found.points[b])];
          for (std::size_t i = 0; i < made.size(); ++i) made[i] += found.weights[b] * v[i];
        }
        EXPECT_NEAR(sum, found.norm, 1e-9 * (1 + expected));
        for (std::size_t i = 0; i < made.size(); ++i) EXPECT_NEAR(made[i], x[i], 1e-8);
      }
    }
}

TEST(PolytopeNorm, OfTheCrossAndTheCube) {
  PolytopeNorm cross = made_of({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 3);
  EXPECT_NEAR(cross.combine({1, -2, 3}, 0).norm, 6, 1e-12);
  PolytopeNorm cube = made_of({{1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {1, -1, -1}}, 3);
  EXPECT_NEAR(cube.combine({1, -2, 3}, 0).norm, 3, 1e-12);
  // Asked only whether it is at most 4, it may stop early, never beyond.
  EXPECT_LE(cube.combine({1, -2, 3}, 4).norm, 4);
}

}  // namespace
}  // namespace arete
