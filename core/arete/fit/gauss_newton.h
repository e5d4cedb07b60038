// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <vector>

namespace arete {

/// Numbers that a model makes of its parameters; nothing where it has none.
using Model = std::function<std::optional<std::vector<double>>(const std::vector<double>&)>;

struct LeastSquares {
  std::vector<double> parameters;
  double sum_of_squares = 0;
  int steps = 0;
  bool converged = false;
};

/// The parameters whose model comes nearest to `target` in the sense of least squares, by
/// Gauss-Newton steps damped where they lead uphill (Levenberg-Marquardt), from `start`. A model
/// that is affine in its parameters is solved by the first step.
///
/// Derivatives are central differences with `step`, exact for models of second degree. Entries
/// whose `counts` is 0 are left out. \throws std::invalid_argument if there is no model at the
/// start.
[[nodiscard]] LeastSquares gauss_newton(const Model& model, const std::vector<double>& target,
                                        const std::vector<char>& counts, std::vector<double> start,
                                        double step = 1e-3, int most_steps = 60);

}  // namespace arete
