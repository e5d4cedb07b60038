// SPDX-License-Identifier: MIT
#include "arete/fractal/spectrum.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "arete/algebra/characteristic_polynomial.h"
#include "arete/algebra/real_roots.h"

namespace arete {
namespace {

std::vector<double> approximate_real_roots(const Coefficients& p) {
  const auto n = static_cast<Eigen::Index>(p.size()) - 1;
  Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i + 1 < n; ++i) companion(i + 1, i) = 1;
  for (Eigen::Index i = 0; i < n; ++i)
    companion(i, n - 1) = to_double(Rational(-p[static_cast<std::size_t>(i)] / p.back()));
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(companion, /*computeEigenvectors=*/false);
  std::vector<double> roots;
  for (Eigen::Index i = 0; i < n; ++i)
    if (std::abs(solver.eigenvalues()[i].imag()) < 1e-6)
      roots.push_back(solver.eigenvalues()[i].real());
  return roots;
}

// One of the convergents of the continued fraction of x is the root near x, if that is rational.
std::optional<Rational> rational_root_near(const Coefficients& p, double x) {
  Integer p0 = 1, q0 = 0;
  auto p1 = Integer(static_cast<long long>(std::floor(x)));
  Integer q1 = 1;
  double rest = x - std::floor(x);
  for (int step = 0; step < 40; ++step) {
    const Rational guess(p1, q1);
    if (std::abs(to_double(guess) - x) < 1e-6 && value_at(p, guess) == 0) return guess;
    if (rest < 1e-12 || q1 > 10'000'000) return std::nullopt;
    const double inverse = 1 / rest;
    const Integer term(static_cast<long long>(std::floor(inverse)));
    rest = inverse - std::floor(inverse);
    std::swap(p0, p1);
    std::swap(q0, q1);
    p1 += term * p0;
    q1 += term * q0;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::vector<Rational>> rational_spectrum(const Matrix<Rational>& a) {
  Coefficients rest = characteristic_polynomial(a);
  std::vector<Rational> eigenvalues;
  if (rest.size() < 2) return eigenvalues;
  const Coefficients simple = divided(rest, gcd_of(rest, derivative_of(rest))).quotient;
  for (const double root : approximate_real_roots(simple)) {
    const auto exact = rational_root_near(simple, root);
    if (!exact) return std::nullopt;
    const Coefficients factor{Rational(-*exact), Rational(1)};
    while (rest.size() > 1 && value_at(rest, *exact) == 0) {
      rest = divided(rest, factor).quotient;
      eigenvalues.push_back(*exact);
    }
  }
  if (rest.size() > 1) return std::nullopt;
  std::sort(eigenvalues.begin(), eigenvalues.end(), [](const Rational& x, const Rational& y) {
    return abs(x) != abs(y) ? abs(x) > abs(y) : x > y;
  });
  return eigenvalues;
}

}  // namespace arete
