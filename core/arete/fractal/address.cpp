// SPDX-License-Identifier: MIT
#include "arete/fractal/address.h"

#include <map>
#include <stdexcept>

#include "arete/algebra/linear_solve.h"

namespace arete {
namespace {

std::vector<Rational> applied(const std::vector<Rational>& row, const Matrix<Rational>& a) {
  std::vector<Rational> result(static_cast<std::size_t>(a.cols()), Rational(0));
  for (int i = 0; i < a.rows(); ++i)
    for (int j = 0; j < a.cols(); ++j)
      result[static_cast<std::size_t>(j)] += row[static_cast<std::size_t>(i)] * a(i, j);
  return result;
}

}  // namespace

std::optional<std::vector<Rational>> fixed_row(const Matrix<Rational>& a) {
  const int n = a.rows();
  Matrix<Rational> equations(n + 1, n);
  std::vector<Rational> right(static_cast<std::size_t>(n) + 1, Rational(0));
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) equations(j, i) = a(i, j) - Rational(i == j ? 1 : 0);
  for (int i = 0; i < n; ++i) equations(n, i) = 1;
  right.back() = 1;
  return solve_unique(equations, right);
}

std::optional<std::vector<Rational>> limit_row(const MatrixSet<Rational>& set, const Rational& x,
                                               int max_digits) {
  if (x < 0 || x > 1) throw std::invalid_argument("the parameter of an arc lies in 0..1");
  const int m = set.arity();
  Address digits;
  std::map<Rational, std::size_t> seen;  // remainder -> digits before it
  Rational rest = x;
  while (!seen.contains(rest)) {
    if (static_cast<int>(digits.size()) >= max_digits) return std::nullopt;
    seen[rest] = digits.size();
    const Rational scaled = rest * m;
    // The end of the arc is 0.ddd... with d = m - 1; a number has no such tail otherwise.
    const int digit = rest == 1 ? m - 1 : static_cast<int>(floor(scaled));
    digits.push_back(digit);
    rest = scaled - digit;
  }
  const auto start = digits.begin() + static_cast<std::ptrdiff_t>(seen[rest]);
  auto row = fixed_row(address_product(set, {start, digits.end()}));
  if (!row) return std::nullopt;
  for (auto digit = start; digit != digits.begin();) row = applied(*row, set[*--digit]);
  return row;
}

}  // namespace arete
