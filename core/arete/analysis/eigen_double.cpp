// SPDX-License-Identifier: MIT
#include "arete/analysis/eigen_double.h"

#include <Eigen/Dense>
#include <cmath>

namespace arete {
namespace {

Eigen::MatrixXd to_eigen(const Matrix<double>& a) {
  Eigen::MatrixXd result(a.rows(), a.cols());
  for (int i = 0; i < a.rows(); ++i)
    for (int j = 0; j < a.cols(); ++j) result(i, j) = a(i, j);
  return result;
}

}  // namespace

double approximate_spectral_radius(const Matrix<double>& a) {
  if (a.rows() == 1) return std::abs(a(0, 0));
  if (a.rows() == 2) {
    const double half_trace = (a(0, 0) + a(1, 1)) / 2;
    const double determinant = a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0);
    const double discriminant = half_trace * half_trace - determinant;
    return discriminant >= 0 ? std::abs(half_trace) + std::sqrt(discriminant)
                             : std::sqrt(determinant);
  }
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(to_eigen(a), /*computeEigenvectors=*/false);
  return solver.eigenvalues().cwiseAbs().maxCoeff();
}

LeadingVectors leading_vectors(const Matrix<double>& a) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(to_eigen(a));
  const auto& values = solver.eigenvalues();
  LeadingVectors leading;
  leading.radius = values.cwiseAbs().maxCoeff();
  const auto add = [&leading](const Eigen::VectorXd& v) {
    if (v.norm() > 1e-12) leading.vectors.emplace_back(v.data(), v.data() + v.size());
  };
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (std::abs(values[i]) < leading.radius * (1 - 1e-8) || values[i].imag() < 0) continue;
    add(solver.eigenvectors().col(i).real());
    if (values[i].imag() > 0) add(solver.eigenvectors().col(i).imag());
  }
  return leading;
}

}  // namespace arete
