// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace arete {

/// The norm whose unit ball is the symmetric convex hull of points v_1..v_K that span R^n:
///
///     ||x|| = min { sum |l_j| : sum l_j v_j = x }.
///
/// A linear program with n rows, solved by the revised simplex method in double precision. Because
/// every column may be used with either sign, any n independent columns are a feasible start, so
/// there is no first phase, and each basis met on the way is an upper bound. Results are proposals:
/// whoever claims something checks the combination in exact arithmetic (invariant_polytope.h).
/// n is small here (at most some twenty) and K some thousand, which is why a general LP library
/// would cost more in its interface than it saves.
class PolytopeNorm {
 public:
  /// The n independent points of the first basis are the first n points.
  explicit PolytopeNorm(int dimension) : dimension_(dimension) {}

  void add(std::vector<double> point);
  [[nodiscard]] int count() const { return static_cast<int>(points_.size()); }
  [[nodiscard]] const std::vector<double>& point(int k) const {
    return points_[static_cast<std::size_t>(k)];
  }

  /// A combination of at most n points that gives x.
  struct Combination {
    double norm = 0;          ///< sum of |weights|: at least ||x||, equal to it when optimal
    std::vector<int> points;  ///< the basis
    std::vector<double> weights;
  };

  /// Stops as soon as a combination with norm <= good_enough is found, or the norm is proved (up to
  /// rounding) to be above it; with good_enough = 0 the norm itself is computed. Needs count() >=
  /// n.
  [[nodiscard]] Combination combine(const std::vector<double>& x, double good_enough);

 private:
  bool invert_basis();

  int dimension_;
  std::vector<std::vector<double>> points_;
  std::vector<int> basis_;
  std::vector<double> inverse_;  // of the basis matrix, row major
};

}  // namespace arete
