// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "arete/fractal/curve_system.h"
#include "arete/fractal/pairs.h"
#include "support/oracle.h"

namespace arete::test {

/// A matrix of a record: a list of rows.
inline Matrix<Rational> exact_matrix(const nlohmann::json& rows) {
  std::vector<std::vector<Rational>> table;
  for (const auto& row : rows) table.push_back(exact_list(row));
  return matrix_of_rows(table);
}

/// `chaikin`, `de_rham`, `bezier2` as the records name them.
inline MatrixPair<Rational> named_pair(const std::string& name) {
  if (name == "chaikin") return corner_cutting_pair(Rational(1, 4), Rational(1, 4));
  if (name == "de_rham") return corner_cutting_pair(Rational(1, 3), Rational(1, 3));
  if (name.rfind("bezier", 0) == 0) return bezier_pair<Rational>(std::stoi(name.substr(6)));
  throw std::runtime_error("no pair is called " + name);
}

/// Coefficients of a characteristic polynomial in the records' order, highest power first.
inline std::vector<Rational> highest_first(std::vector<Rational> coefficients) {
  return {coefficients.rbegin(), coefficients.rend()};
}

/// A control polygon in general position, n points in the plane.
inline Matrix<Rational> some_points(int n) {
  Matrix<Rational> points(n, 2);
  for (int i = 0; i < n; ++i) {
    points(i, 0) = Rational(3 * i - (i % 3), 2);
    points(i, 1) = Rational((7 * i * i + 3 * i) % 11 - 5);
  }
  return points;
}

}  // namespace arete::test
