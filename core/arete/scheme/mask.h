// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "arete/algebra/laurent_polynomial.h"
#include "arete/algebra/rational.h"
#include "arete/scheme/error.h"

namespace arete {

/// The mask of an m-ary subdivision scheme: finitely many exact coefficients a_first..a_last with
///
///     p'_k = sum_j a_{k - m j} p_j.
///
/// Always true of it: 2 <= arity <= 64; the first and the last coefficient are not zero; every
/// phase (the coefficients of one residue of k modulo m) sums to 1, so constants are kept.
class Mask {
 public:
  static constexpr int largest_arity = 64;
  static constexpr int largest_size = 4096;

  /// coefficients[i] is a_{first + i}; zeros at both ends are trimmed.
  /// \throws InvalidScheme if the arity is out of range, there is no non-zero coefficient, there
  /// are more than largest_size, or a phase does not sum to 1 (the message lists all sums).
  Mask(int arity, int first, std::vector<Rational> coefficients);
  Mask(int arity, LaurentPolynomial<Rational> symbol);

  [[nodiscard]] int arity() const { return arity_; }
  [[nodiscard]] int first() const { return symbol_.lowest(); }
  [[nodiscard]] int last() const { return symbol_.highest(); }
  [[nodiscard]] const std::vector<Rational>& coefficients() const { return symbol_.coefficients(); }
  /// a_k, zero outside first..last.
  [[nodiscard]] Rational operator[](int k) const { return symbol_[k]; }
  /// a(z) = sum a_k z^k.
  [[nodiscard]] const LaurentPolynomial<Rational>& symbol() const { return symbol_; }

  /// The parametric shift a'(1)/m: linear data p_j = j go to (i - tau)/m at the new index i when
  /// two sum rules hold.
  [[nodiscard]] Rational tau() const;

  [[nodiscard]] friend bool operator==(const Mask&, const Mask&) = default;

 private:
  int arity_;
  LaurentPolynomial<Rational> symbol_;
};

/// The mask of `steps` steps of the scheme taken as one step of arity m^steps.
[[nodiscard]] Mask iterated(const Mask& mask, int steps);

/// `[-1/16, 0, 9/16, 1, 9/16, 0, -1/16]`.
[[nodiscard]] std::string coefficients_text(const Mask& mask);

}  // namespace arete
