// SPDX-License-Identifier: MIT
#include "arete/analysis/stability.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

#include "arete/algebra/real_roots.h"

namespace arete {
namespace {

constexpr std::size_t most_coefficients = 1200;

// Whether p (not zero) has a root on |z| = 1.
bool has_unit_root(Coefficients p) {
  // Roots on the circle are roots of the reversed polynomial too: keep the common part, which is
  // self-reciprocal up to sign.
  while (!p.empty() && p.front() == 0) p.erase(p.begin());
  Coefficients reversed(p.rbegin(), p.rend());
  Coefficients common = gcd_of(p, reversed);
  if (value_at(common, 1) == 0 || value_at(common, -1) == 0) return true;
  if (common.size() <= 1) return false;
  // Without the roots +-1 it is palindromic of even degree 2h: z^-h common(z) is a polynomial in
  // x = z + 1/z, and |z| = 1 means -2 <= x <= 2. z^k + z^-k = T_k with T_0 = 2, T_1 = x.
  const std::size_t half = (common.size() - 1) / 2;
  Coefficients in_x = {common[half]};
  Coefficients before = {2};
  Coefficients current = {0, 1};
  for (std::size_t k = 1; k <= half; ++k) {
    in_x.resize(std::max(in_x.size(), current.size()), Rational(0));
    for (std::size_t i = 0; i < current.size(); ++i) in_x[i] += common[half + k] * current[i];
    Coefficients next(current.size() + 1, Rational(0));
    for (std::size_t i = 0; i < current.size(); ++i) next[i + 1] += current[i];
    for (std::size_t i = 0; i < before.size(); ++i) next[i] -= before[i];
    before = std::move(current);
    current = std::move(next);
  }
  return distinct_real_roots(trimmed(in_x), -2, 2) > 0;
}

bool has_symmetric_roots(const Mask& mask) {
  const int m = mask.arity();
  Coefficients common;
  for (int r = 0; r < m; ++r) {
    Coefficients part;
    for (int k = mask.first() + r; k <= mask.last(); k += m) part.push_back(mask[k]);
    common = gcd_of(trimmed(std::move(part)), std::move(common));
    if (common.size() == 1) return false;
  }
  return has_unit_root(common);
}

// The n-th cyclotomic polynomial: (z^n - 1) divided by those of the proper divisors of n.
Coefficients cyclotomic(int n, std::vector<Coefficients>& known) {
  Coefficients p(static_cast<std::size_t>(n) + 1, Rational(0));
  p.front() = -1;
  p.back() = 1;
  for (int d = 1; d < n; ++d) {
    if (n % d != 0) continue;
    if (known[static_cast<std::size_t>(d)].empty())
      known[static_cast<std::size_t>(d)] = cyclotomic(d, known);
    const Coefficients& divisor = known[static_cast<std::size_t>(d)];
    p = divided(std::move(p), divisor).quotient;
  }
  return p;
}

int totient(int n) {
  int result = n;
  for (int p = 2; p * p <= n; ++p)
    if (n % p == 0) {
      result -= result / p;
      while (n % p == 0) n /= p;
    }
  return n > 1 ? result - result / n : result;
}

// A quick look in floating point: is a(e^{2 pi i (1/m + 1/n)}) far from zero?
bool clearly_not_a_root(const Mask& mask, int n) {
  const double turn = 1.0 / mask.arity() + 1.0 / n;
  std::complex<double> value = 0;
  double size = 0;
  for (int k = mask.first(); k <= mask.last(); ++k) {
    const double c = to_double(mask[k]);
    value += c * std::polar(1.0, 2 * std::numbers::pi * std::fmod(turn * k, 1.0));
    size += std::abs(c);
  }
  return std::abs(value) > 1e-6 * size;
}

bool has_root_cycle(const Mask& mask) {
  const int m = mask.arity();
  const int degree = mask.last() - mask.first();
  const int most = degree / (m - 1);  // of phi(n)
  // phi(n) >= sqrt(n/2), and for n > 30 phi(n) > n / 5 as long as n < 30030.
  const int last = std::min(2 * most * most, std::max(30, 5 * most + 5));
  std::vector<Coefficients> known(static_cast<std::size_t>(last) + 1);
  for (int n = 2; n <= last; ++n) {
    if (std::gcd(n, m) != 1 || totient(n) > most || clearly_not_a_root(mask, n)) continue;
    const Coefficients phi = cyclotomic(n, known);
    Coefficients product(phi.size() + mask.coefficients().size() - 1, Rational(0));
    for (std::size_t i = 0; i < phi.size(); ++i)
      for (std::size_t j = 0; j < mask.coefficients().size(); ++j)
        product[i + j] += phi[i] * mask.coefficients()[j];
    Coefficients spread((phi.size() - 1) * static_cast<std::size_t>(m) + 1, Rational(0));
    for (std::size_t i = 0; i < phi.size(); ++i) spread[i * static_cast<std::size_t>(m)] = phi[i];
    if (divided(std::move(product), spread).remainder.empty()) return true;
  }
  return false;
}

}  // namespace

Stability shift_stability(const Mask& mask) {
  if (mask.coefficients().size() > most_coefficients) return Stability::unknown;
  return has_symmetric_roots(mask) || has_root_cycle(mask) ? Stability::unstable
                                                           : Stability::stable;
}

}  // namespace arete
