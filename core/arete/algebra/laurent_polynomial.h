// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace arete {

/// A Laurent polynomial  sum_i c_i z^i  (i may be negative) over any commutative ring R that can
/// be made from int: exact rationals, doubles, or polynomials in a parameter.
///
/// Always trimmed: neither the lowest nor the highest coefficient is zero; the zero polynomial has
/// no coefficients and `lowest() == 0`.
template <class R>
class LaurentPolynomial {
 public:
  LaurentPolynomial() = default;
  /// The constant `value` (so that a polynomial ring can itself serve as a coefficient ring).
  LaurentPolynomial(int value) : LaurentPolynomial(0, {R(value)}) {}  // NOLINT: ring embedding
  /// coefficients[i] belongs to z^(lowest + i).
  LaurentPolynomial(int lowest, std::vector<R> coefficients)
      : lowest_(lowest), coefficients_(std::move(coefficients)) {
    trim();
  }

  [[nodiscard]] static LaurentPolynomial monomial(R coefficient, int exponent) {
    return LaurentPolynomial(exponent, {std::move(coefficient)});
  }

  [[nodiscard]] bool is_zero() const { return coefficients_.empty(); }
  [[nodiscard]] int lowest() const { return lowest_; }
  /// Highest exponent; lowest() - 1 for the zero polynomial.
  [[nodiscard]] int highest() const { return lowest_ + static_cast<int>(coefficients_.size()) - 1; }
  [[nodiscard]] const std::vector<R>& coefficients() const { return coefficients_; }
  /// The coefficient of z^exponent, zero outside the support.
  [[nodiscard]] R operator[](int exponent) const {
    if (exponent < lowest_ || exponent > highest()) return R(0);
    return coefficients_[static_cast<std::size_t>(exponent - lowest_)];
  }

  [[nodiscard]] friend bool operator==(const LaurentPolynomial& a, const LaurentPolynomial& b) {
    return a.lowest_ == b.lowest_ && a.coefficients_ == b.coefficients_;
  }

  [[nodiscard]] friend LaurentPolynomial operator+(const LaurentPolynomial& a,
                                                   const LaurentPolynomial& b) {
    if (a.is_zero()) return b;
    if (b.is_zero()) return a;
    const int lowest = std::min(a.lowest(), b.lowest());
    const int highest = std::max(a.highest(), b.highest());
    std::vector<R> sum;
    sum.reserve(static_cast<std::size_t>(highest - lowest + 1));
    for (int i = lowest; i <= highest; ++i) sum.push_back(a[i] + b[i]);
    return LaurentPolynomial(lowest, std::move(sum));
  }

  [[nodiscard]] friend LaurentPolynomial operator-(const LaurentPolynomial& a) {
    std::vector<R> negated;
    negated.reserve(a.coefficients_.size());
    for (const R& c : a.coefficients_) negated.push_back(R(0) - c);
    return LaurentPolynomial(a.lowest_, std::move(negated));
  }

  [[nodiscard]] friend LaurentPolynomial operator-(const LaurentPolynomial& a,
                                                   const LaurentPolynomial& b) {
    return a + (-b);
  }

  [[nodiscard]] friend LaurentPolynomial operator*(const LaurentPolynomial& a,
                                                   const LaurentPolynomial& b) {
    if (a.is_zero() || b.is_zero()) return {};
    std::vector<R> product(a.coefficients_.size() + b.coefficients_.size() - 1, R(0));
    for (std::size_t i = 0; i < a.coefficients_.size(); ++i)
      for (std::size_t j = 0; j < b.coefficients_.size(); ++j)
        product[i + j] = product[i + j] + a.coefficients_[i] * b.coefficients_[j];
    return LaurentPolynomial(a.lowest_ + b.lowest_, std::move(product));
  }

  /// The polynomial with every coefficient multiplied by `factor`.
  [[nodiscard]] LaurentPolynomial scaled(const R& factor) const {
    std::vector<R> scaled_coefficients;
    scaled_coefficients.reserve(coefficients_.size());
    for (const R& c : coefficients_) scaled_coefficients.push_back(c * factor);
    return LaurentPolynomial(lowest_, std::move(scaled_coefficients));
  }

  /// z^by times the polynomial.
  [[nodiscard]] LaurentPolynomial shifted(int by) const {
    return is_zero() ? *this : LaurentPolynomial(lowest_ + by, coefficients_);
  }

  /// p(z^m), m >= 1: two steps of an m-ary scheme have the symbol a(z) a(z^m).
  [[nodiscard]] LaurentPolynomial dilated(int m) const {
    if (is_zero()) return *this;
    std::vector<R> spread((coefficients_.size() - 1) * static_cast<std::size_t>(m) + 1, R(0));
    for (std::size_t i = 0; i < coefficients_.size(); ++i)
      spread[i * static_cast<std::size_t>(m)] = coefficients_[i];
    return LaurentPolynomial(lowest_ * m, std::move(spread));
  }

  /// p(1).
  [[nodiscard]] R sum() const {
    R total(0);
    for (const R& c : coefficients_) total = total + c;
    return total;
  }

  /// p'(z).
  [[nodiscard]] LaurentPolynomial derivative() const {
    std::vector<R> result;
    result.reserve(coefficients_.size());
    for (std::size_t i = 0; i < coefficients_.size(); ++i)
      result.push_back(coefficients_[i] * R(lowest_ + static_cast<int>(i)));
    return LaurentPolynomial(lowest_ - 1, std::move(result));
  }

  /// The quotient by 1 + z + ... + z^(m-1) if that divides exactly, nothing otherwise.
  /// Dividing out this factor k times is what "k sum rules" means for an m-ary symbol.
  [[nodiscard]] std::optional<LaurentPolynomial> divided_by_smoothing_factor(int m) const {
    if (is_zero()) return *this;
    const auto n = static_cast<std::size_t>(m);
    if (coefficients_.size() < n) return std::nullopt;
    std::vector<R> quotient(coefficients_.size() - n + 1, R(0));
    // Long division from the lowest power; `window` is the sum of the last m - 1 quotient terms.
    R window(0);
    for (std::size_t i = 0; i < coefficients_.size(); ++i) {
      const R term = coefficients_[i] - window;
      if (i < quotient.size()) {
        quotient[i] = term;
        window = window + term;
      } else if (!(term == R(0))) {
        return std::nullopt;
      }
      if (i + 1 >= n && i + 1 - n < quotient.size()) window = window - quotient[i + 1 - n];
    }
    return LaurentPolynomial(lowest_, std::move(quotient));
  }

 private:
  void trim() {
    const auto is_zero_coefficient = [](const R& c) { return c == R(0); };
    while (!coefficients_.empty() && is_zero_coefficient(coefficients_.back()))
      coefficients_.pop_back();
    const auto first =
        std::find_if_not(coefficients_.begin(), coefficients_.end(), is_zero_coefficient);
    lowest_ += static_cast<int>(first - coefficients_.begin());
    coefficients_.erase(coefficients_.begin(), first);
    if (coefficients_.empty()) lowest_ = 0;
  }

  int lowest_ = 0;
  std::vector<R> coefficients_;
};

/// p^exponent, exponent >= 0.
template <class R>
[[nodiscard]] LaurentPolynomial<R> power(const LaurentPolynomial<R>& p, int exponent) {
  LaurentPolynomial<R> result(1);
  for (int i = 0; i < exponent; ++i) result = result * p;
  return result;
}

/// 1 + z + ... + z^(m-1).
template <class R>
[[nodiscard]] LaurentPolynomial<R> smoothing_factor(int m) {
  return LaurentPolynomial<R>(0, std::vector<R>(static_cast<std::size_t>(m), R(1)));
}

}  // namespace arete
