// SPDX-License-Identifier: MIT
#include "arete/fit/gauss_newton.h"

#include <Eigen/Dense>
#include <cmath>
#include <stdexcept>

namespace arete {
namespace {

using Values = std::vector<double>;

struct Equations {
  const Values& target;
  const std::vector<char>& counts;

  [[nodiscard]] double squares(const Values& values) const {
    double sum = 0;
    for (std::size_t i = 0; i < target.size(); ++i)
      if (counts[i] != 0) sum += (target[i] - values[i]) * (target[i] - values[i]);
    return sum;
  }

  [[nodiscard]] double dot(const Values& a, const Values& b) const {
    double sum = 0;
    for (std::size_t i = 0; i < target.size(); ++i)
      if (counts[i] != 0) sum += a[i] * b[i];
    return sum;
  }
};

// The derivative of the model by one parameter; one-sided at the edge of where there is a model.
std::optional<Values> derivative(const Model& model, Values at, std::size_t parameter,
                                 const Values& here, double step) {
  const double centre = at[parameter];
  at[parameter] = centre + step;
  auto above = model(at);
  at[parameter] = centre - step;
  auto below = model(at);
  if (!above && !below) return std::nullopt;
  const double width = above && below ? 2 * step : step;
  Values result = above ? *std::move(above) : here;
  const Values& lower = below ? *below : here;
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = (result[i] - lower[i]) / width;
  return result;
}

}  // namespace

LeastSquares gauss_newton(const Model& model, const Values& target, const std::vector<char>& counts,
                          Values start, double step, int most_steps) {
  const Equations equations{target, counts};
  auto here = model(start);
  if (!here) throw std::invalid_argument("there is no model at the start");
  LeastSquares result{std::move(start), equations.squares(*here)};
  const auto n = static_cast<Eigen::Index>(result.parameters.size());
  double damping = 0;
  while (result.steps < most_steps && !result.converged) {
    std::vector<Values> columns;
    for (std::size_t i = 0; i < result.parameters.size(); ++i) {
      auto column = derivative(model, result.parameters, i, *here, step);
      if (!column) return result;
      columns.push_back(*std::move(column));
    }
    Values left = target;
    for (std::size_t i = 0; i < left.size(); ++i) left[i] -= (*here)[i];
    Eigen::MatrixXd normal(n, n);
    Eigen::VectorXd right(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      right(i) = equations.dot(columns[static_cast<std::size_t>(i)], left);
      for (Eigen::Index j = 0; j <= i; ++j)
        normal(i, j) = normal(j, i) = equations.dot(columns[static_cast<std::size_t>(i)],
                                                    columns[static_cast<std::size_t>(j)]);
    }
    ++result.steps;
    while (true) {
      Eigen::MatrixXd damped = normal;
      damped.diagonal() *= 1 + damping;
      // Parameters without any influence stay where they are.
      const Eigen::VectorXd move = damped.completeOrthogonalDecomposition().solve(right);
      Values trial = result.parameters;
      for (std::size_t i = 0; i < trial.size(); ++i) trial[i] += move(static_cast<Eigen::Index>(i));
      auto there = model(trial);
      const double squares = there ? equations.squares(*there) : INFINITY;
      const bool small =
          move.norm() <= 1e-10 * (1 + Eigen::Map<const Eigen::VectorXd>(trial.data(), n).norm());
      if (squares <= result.sum_of_squares) {
        result.converged =
            small || result.sum_of_squares - squares <= 1e-13 * result.sum_of_squares;
        result.parameters = std::move(trial);
        result.sum_of_squares = squares;
        here = std::move(there);
        damping = damping < 1e-6 ? 0 : damping / 10;
        break;
      }
      // Rounding alone can make the best point seem higher.
      if (small || damping > 1e12) {
        result.converged = true;
        break;
      }
      damping = damping == 0 ? 1e-3 : damping * 10;
    }
  }
  return result;
}

}  // namespace arete
