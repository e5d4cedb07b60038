// SPDX-License-Identifier: MIT
#include "arete/variational/relax.h"

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <string>

#include "arete/field/error.h"
#include "arete/variational/cotangent.h"

namespace arete {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;
using Solver = Eigen::SimplicialLDLT<SparseMatrix>;

// The free points' numbers among the unknowns, -1 for fixed ones.
std::vector<int> unknowns_of(const SurfaceMesh& mesh) {
  std::vector<int> numbers(mesh.points.size(), -1);
  int count = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (!mesh.fixed[i]) numbers[i] = count++;
  return numbers;
}

// Free points that no path of edges joins to a fixed one.
void check_connected(const SurfaceMesh& mesh) {
  std::vector<std::size_t> parent(mesh.points.size() + 1);
  for (std::size_t i = 0; i < parent.size(); ++i) parent[i] = i;
  const auto root = [&parent](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  const std::size_t ground = mesh.points.size();
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    if (mesh.fixed[i]) parent[root(i)] = root(ground);
  for (const auto& [a, b, c] : mesh.triangles) {
    parent[root(static_cast<std::size_t>(a))] = root(static_cast<std::size_t>(b));
    parent[root(static_cast<std::size_t>(b))] = root(static_cast<std::size_t>(c));
  }
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    if (root(i) != root(ground))
      throw InvalidField("point " + std::to_string(i) +
                         " of the surface is joined to no fixed point, so that its part would "
                         "shrink to nothing; fix a boundary");
}

/// One sparse system a step; its pattern is always the same.
class Stepper {
 public:
  explicit Stepper(SurfaceMesh& mesh) : mesh_(mesh), unknowns_(unknowns_of(mesh)) {
    count_ = static_cast<int>(
        std::count_if(unknowns_.begin(), unknowns_.end(), [](int i) { return i >= 0; }));
  }

  [[nodiscard]] int count() const { return count_; }

  /// Pinkall-Polthier: L y = 0 inside. False if it could not be solved.
  [[nodiscard]] bool spread() {
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(count_, 3);
    const auto weight = [](std::size_t, std::size_t) { return 1.0; };
    const auto known = [&](int row, std::size_t fixed, double entry) {
      for (int k = 0; k < 3; ++k)
        right(row, k) -= entry * mesh_.points[fixed][static_cast<std::size_t>(k)];
    };
    if (!assemble(weight, known)) return false;
    const Eigen::MatrixXd solution = solver_.solve(right);
    if (solver_.info() != Eigen::Success || !solution.allFinite()) return false;
    for_free([&](std::size_t i, int row) {
      for (int k = 0; k < 3; ++k) mesh_.points[i][static_cast<std::size_t>(k)] = solution(row, k);
    });
    return true;
  }

  /// (N^T L N) phi = -N^T L X.
  [[nodiscard]] bool move_along_normals() {
    const std::vector<Point3> normals = unit_normals(mesh_);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(count_);
    for_each_cotangent(mesh_, [&](int i, int j, double w) {
      const auto a = static_cast<std::size_t>(i);
      const auto b = static_cast<std::size_t>(j);
      const Point3 d = difference(mesh_.points[a], mesh_.points[b]);
      if (unknowns_[a] >= 0) right[unknowns_[a]] -= w * dot(d, normals[a]);
      if (unknowns_[b] >= 0) right[unknowns_[b]] += w * dot(d, normals[b]);
    });
    const auto weight = [&](std::size_t a, std::size_t b) { return dot(normals[a], normals[b]); };
    if (!assemble(weight, [](int, std::size_t, double) {})) return false;
    const Eigen::VectorXd phi = solver_.solve(right);
    if (solver_.info() != Eigen::Success || !phi.allFinite()) return false;
    for_free([&](std::size_t i, int row) {
      for (std::size_t k = 0; k < 3; ++k) mesh_.points[i][k] += phi[row] * normals[i][k];
    });
    return true;
  }

 private:
  template <class F>
  void for_free(F&& visit) {
    for (std::size_t i = 0; i < unknowns_.size(); ++i)
      if (unknowns_[i] >= 0) visit(i, unknowns_[i]);
  }

  // Factors the matrix of entries L_ij * weight(i, j) between free points; known(row, j, L_ij) is
  // told of those to fixed ones.
  template <class Weight, class Known>
  [[nodiscard]] bool assemble(Weight&& weight, Known&& known) {
    entries_.clear();
    const auto add = [&](int i, int j, double value) {
      const auto a = static_cast<std::size_t>(i);
      const auto b = static_cast<std::size_t>(j);
      if (unknowns_[a] < 0) return;
      if (unknowns_[b] >= 0)
        entries_.emplace_back(unknowns_[a], unknowns_[b], value * weight(a, b));
      else
        known(unknowns_[a], b, value);
    };
    for_each_cotangent(mesh_, [&](int i, int j, double w) {
      add(i, i, w);
      add(j, j, w);
      add(i, j, -w);
      add(j, i, -w);
    });
    SparseMatrix matrix(count_, count_);
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    if (!analyzed_) solver_.analyzePattern(matrix);
    analyzed_ = true;
    solver_.factorize(matrix);
    return solver_.info() == Eigen::Success;
  }

  SurfaceMesh& mesh_;
  std::vector<int> unknowns_;
  int count_ = 0;
  std::vector<Eigen::Triplet<double>> entries_;
  Solver solver_;
  bool analyzed_ = false;
};

double largest_curvature(const SurfaceMesh& mesh) {
  double largest = 0;
  for (const double h : mean_curvatures(mesh)) largest = std::max(largest, std::abs(h));
  return largest;
}

}  // namespace

RelaxReport relax(SurfaceMesh& mesh, const RelaxOptions& options) {
  check_mesh(mesh);
  check_connected(mesh);
  RelaxReport report;
  report.areas.push_back(surface_area(mesh));
  if (!(report.areas.back() > 0))
    throw InvalidField("the surface to be relaxed has no area; its boundary must not be a line");
  const auto measure = [&] {
    report.max_mean_curvature = largest_curvature(mesh);
    report.converged =
        report.max_mean_curvature * std::sqrt(report.areas.back()) < options.tolerance;
  };
  measure();
  Stepper stepper(mesh);
  const int steps = options.spreading_steps + options.normal_steps;
  for (int step = 0; step < steps && !report.converged && stepper.count() > 0; ++step) {
    const std::vector<Point3> before = mesh.points;
    const bool spreading = step < options.spreading_steps;
    const bool solved = spreading ? stepper.spread() : stepper.move_along_normals();
    const double area = solved ? surface_area(mesh) : 0;
    if (!solved || !(area <= report.areas.back() * (1 + 1e-12)) || !(area > 0)) {
      mesh.points = before;
      break;
    }
    report.areas.push_back(std::min(area, report.areas.back()));
    if (options.progress) options.progress(step + 1, area);
    measure();
  }
  return report;
}

}  // namespace arete
