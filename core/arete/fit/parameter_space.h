// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "arete/scheme/scheme.h"

namespace arete {

/// Members of one family around a start, as an affine space: parameters that move, the others
/// held, and only such moves that keep
/// - every phase's sum (constants stay constants),
/// - tau (samples stay where they are),
/// - where the start has two sum rules, both of them (planes stay planes).
/// These are kept exactly, in rationals: a fitted scheme is as well placed as its start.
class ParameterSpace {
 public:
  /// Frees the named parameters; none named: every real parameter of the family with which the mask
  /// stays affine (of those that only together do not, such as nu and omega, the later one), and
  /// the entries of lists. \throws InvalidScheme for a name that the family does not have, an
  /// integer, named parameters in which the mask is not affine, or when nothing is free to move.
  ParameterSpace(const Scheme& start, const std::vector<std::string>& names);

  /// How many numbers a member is given by.
  [[nodiscard]] int dimension() const { return static_cast<int>(moves_.size()); }
  /// The parameters that move.
  [[nodiscard]] const std::vector<std::string>& free_names() const { return names_; }
  /// The start moved by u (rounded to 12 decimals, then exact).
  /// \throws InvalidScheme if a parameter leaves its accepted range.
  [[nodiscard]] Scheme at(const std::vector<double>& u) const;

 private:
  /// What is added to one number of the parameters.
  struct Change {
    std::size_t value;
    std::size_t number;
    Rational by;
  };
  using Move = std::vector<Change>;

  [[nodiscard]] std::vector<Move> moves_of(const std::string& name) const;
  [[nodiscard]] Mask mask_after(const std::vector<Move>& moves) const;
  [[nodiscard]] bool affine_with(const std::vector<Move>& moves) const;
  void keep_laws(const std::vector<Move>& moves);

  Scheme start_;
  std::vector<std::string> names_;
  std::vector<Move> moves_;
};

}  // namespace arete
