// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "arete/algebra/laurent_polynomial.h"
#include "arete/algebra/rational.h"

namespace arete {

/// The powers S_q, S_q^2, ... of a subdivision operator (S_q c)_k = sum_j q_{k - m j} c_j with any
/// exact coefficients q, one after the other. Coefficients are kept as integers over one common
/// denominator, which is many times faster than adding fractions.
class OperatorPower {
 public:
  /// Starts at power 1. q may be any Laurent polynomial, arity m >= 2.
  OperatorPower(int arity, const LaurentPolynomial<Rational>& q);

  [[nodiscard]] int power() const { return power_; }

  /// Word-sized multiplications that `advance` would need now (an estimate from the sizes).
  [[nodiscard]] std::int64_t cost_of_next() const;

  /// Goes on to the next power.
  void advance();

  /// || S_q^power ||_inf: max over residues r mod m^power of the sum of |coefficients| at r +
  /// m^power j.
  [[nodiscard]] Rational norm() const { return norm_of_differences(0); }

  /// The same for (1 - z)^order times the symbol of S_q^power: how large the undivided differences
  /// of that order can be after `power` levels.
  [[nodiscard]] Rational norm_of_differences(int order) const;

 private:
  int arity_;
  int power_ = 1;
  std::int64_t dilation_;        // m^power
  std::vector<Integer> factor_;  // q times denominator_
  Integer denominator_;
  std::vector<Integer> product_;  // symbol of S_q^power times scale_
  Integer scale_;                 // denominator_^power
};

}  // namespace arete
