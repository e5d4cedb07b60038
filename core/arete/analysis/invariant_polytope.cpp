// SPDX-License-Identifier: MIT
#include "arete/analysis/invariant_polytope.h"

#include <cmath>

#include "arete/algebra/linear_solve.h"
#include "arete/analysis/eigen_double.h"

namespace arete {
namespace {

constexpr int vertex_bits = 48;
constexpr int weight_bits = 60;
constexpr double explosion = 1e6;
constexpr double small_start = 1.0 / 64;

double on_grid(double value) {
  return std::ldexp(std::nearbyint(std::ldexp(value, vertex_bits)), -vertex_bits);
}

Integer scaled_integer(double value, int bits) {
  return Integer(std::nearbyint(std::ldexp(value, bits)));
}

double largest(const std::vector<double>& v) {
  double most = 0;
  for (const double x : v) most = std::max(most, std::abs(x));
  return most;
}

template <class R>
std::vector<R> times(const Matrix<R>& a, const std::vector<R>& v) {
  std::vector<R> result(v.size(), R(0));
  for (int i = 0; i < a.rows(); ++i)
    for (int j = 0; j < a.cols(); ++j)
      result[static_cast<std::size_t>(i)] =
          result[static_cast<std::size_t>(i)] + a(i, j) * v[static_cast<std::size_t>(j)];
  return result;
}

// The part of v orthogonal to the orthonormal rows of `basis`.
std::vector<double> orthogonal_part(std::vector<double> v,
                                    const std::vector<std::vector<double>>& basis) {
  for (int pass = 0; pass < 2; ++pass)
    for (const auto& b : basis) {
      double product = 0;
      for (std::size_t i = 0; i < v.size(); ++i) product += v[i] * b[i];
      for (std::size_t i = 0; i < v.size(); ++i) v[i] -= product * b[i];
    }
  return v;
}

double length(const std::vector<double>& v) {
  double sum = 0;
  for (const double x : v) sum += x * x;
  return std::sqrt(sum);
}

}  // namespace

std::optional<std::vector<Rational>> exact_eigenvector(const Matrix<Rational>& a,
                                                       const Rational& eigenvalue) {
  const int n = a.rows();
  // Fix one coordinate to 1 and solve for the rest: the answer is unique iff the kernel is a line
  // that is not inside that coordinate's hyperplane.
  for (int fixed = 0; fixed < n; ++fixed) {
    Matrix<Rational> equations(n, n - 1);
    std::vector<Rational> right(static_cast<std::size_t>(n), Rational(0));
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const Rational entry = a(i, j) - (i == j ? eigenvalue : Rational(0));
        if (j == fixed)
          right[static_cast<std::size_t>(i)] = -entry;
        else
          equations(i, j < fixed ? j : j - 1) = entry;
      }
    if (auto rest = solve_unique(equations, right)) {
      rest->insert(rest->begin() + fixed, Rational(1));
      return rest;
    }
  }
  return std::nullopt;
}

InvariantPolytope::InvariantPolytope(const LocalMatrices& local, double radius,
                                     const std::optional<Rational>& exact_radius,
                                     const std::vector<Word>& words, Stop stop)
    : local_(&local),
      radius_(radius),
      exact_radius_(exact_radius),
      stop_(std::move(stop)),
      norm_(local.size) {
  for (const Matrix<Rational>& matrix : local.matrices) {
    Matrix<double> scaled(local.size, local.size);
    for (int i = 0; i < local.size; ++i)
      for (int j = 0; j < local.size; ++j) scaled(i, j) = to_double(matrix(i, j)) / radius;
    scaled_.push_back(std::move(scaled));
  }
  for (const Word& word : words) start_chain(word);
  span_the_space();
}

void InvariantPolytope::add_start(const std::vector<double>& vector, std::vector<Rational> exact) {
  starts_.push_back(vector);
  start_origins_.push_back({-1, -1, std::move(exact)});
}

// The eigenvectors of all rotations of the word, scaled together so that the largest entry of any
// of them is 1: mirror images of words then get mirror images of vectors.
void InvariantPolytope::start_chain(const Word& word) {
  if (exact_radius_) {
    const Matrix<Rational> product = word_product(*local_, word);
    const Rational value = power(*exact_radius_, static_cast<unsigned>(word.size()));
    for (const Rational& eigenvalue : {value, Rational(-value)}) {
      auto vector = exact_eigenvector(product, eigenvalue);
      if (!vector) continue;
      std::vector<std::vector<Rational>> chain = {*vector};
      for (std::size_t i = 0; i + 1 < word.size(); ++i) {
        chain.push_back(times(local_->matrices[static_cast<std::size_t>(word[i])], chain.back()));
        for (Rational& x : chain.back()) x /= *exact_radius_;
      }
      Rational most = 0;
      for (const auto& v : chain)
        for (const Rational& x : v)
          if (abs(x) > most) most = abs(x);
      for (auto& v : chain) {
        std::vector<double> rounded;
        for (Rational& x : v) {
          x /= most;
          rounded.push_back(to_double(x));
        }
        add_start(rounded, v);
      }
    }
    return;
  }
  auto product = Matrix<double>::identity(local_->size);
  for (const int digit : word) product = scaled_[static_cast<std::size_t>(digit)] * product;
  for (const auto& vector : leading_vectors(product).vectors) {
    std::vector<std::vector<double>> chain = {vector};
    double most = largest(vector);
    for (std::size_t i = 0; i + 1 < word.size(); ++i) {
      chain.push_back(times(scaled_[static_cast<std::size_t>(word[i])], chain.back()));
      most = std::max(most, largest(chain.back()));
    }
    for (auto& v : chain) {
      for (double& x : v) x /= most;
      add_start(v, {});
    }
  }
}

int InvariantPolytope::add_vertex(std::vector<double> vector, Origin origin) {
  for (double& x : vector) x = on_grid(x);
  norm_.add(std::move(vector));
  origins_.push_back(std::move(origin));
  return norm_.count() - 1;
}

std::vector<double> InvariantPolytope::image(int vertex, std::size_t digit) const {
  return times(scaled_[digit], norm_.point(vertex));
}

// The linear programs want n independent points first: starts and their images as far as they add a
// dimension, then short coordinate vectors where the images stay in a proper subspace.
void InvariantPolytope::span_the_space() {
  const auto n = static_cast<std::size_t>(local_->size);
  std::vector<std::vector<double>> basis;
  const auto adds_a_dimension = [&basis](const std::vector<double>& v, double threshold) {
    std::vector<double> rest = orthogonal_part(v, basis);
    const double size = length(rest);
    if (size <= threshold * length(v) || length(v) < 1e-8) return false;
    for (double& x : rest) x /= size;
    basis.push_back(std::move(rest));
    return true;
  };
  std::vector<bool> used(starts_.size(), false);
  for (std::size_t s = 0; s < starts_.size(); ++s)
    if (basis.size() < n && adds_a_dimension(starts_[s], 1e-3)) {
      add_vertex(starts_[s], start_origins_[s]);
      used[s] = true;
    }
  for (int k = 0; k < norm_.count() && basis.size() < n; ++k)
    for (std::size_t digit = 0; digit < scaled_.size() && basis.size() < n; ++digit) {
      auto next = image(k, digit);
      if (adds_a_dimension(next, 1e-3))
        add_vertex(std::move(next), {k, static_cast<int>(digit), {}});
    }
  for (std::size_t j = 0; j < n && basis.size() < n; ++j) {
    std::vector<double> unit(n, 0.0);
    unit[j] = small_start;
    if (!adds_a_dimension(unit, 1e-3)) continue;
    std::vector<Rational> exact(n, Rational(0));
    exact[j] = Rational(1) / 64;
    add_vertex(std::move(unit), {-1, -1, std::move(exact)});
  }
  for (std::size_t s = 0; s < starts_.size(); ++s)
    if (!used[s]) add_vertex(starts_[s], start_origins_[s]);
}

bool InvariantPolytope::grow(double tolerance, int max_vertices) {
  if (norm_.count() < local_->size) return false;
  for (int k = 0; k < norm_.count(); ++k)
    for (std::size_t digit = 0; digit < scaled_.size(); ++digit) {
      auto next = image(k, digit);
      if (largest(next) == 0) continue;
      const double size = norm_.combine(next, 1 + tolerance).norm;
      if (size <= 1 + tolerance) continue;
      if (!(size < explosion) || norm_.count() >= max_vertices || must_stop(stop_)) return false;
      add_vertex(std::move(next), {k, static_cast<int>(digit), {}});
    }
  return true;
}

std::optional<Rational> InvariantPolytope::verified_bound() {
  const int n = local_->size;
  if (norm_.count() < n) return std::nullopt;
  Integer denominator = 1;
  for (const auto& matrix : local_->matrices)
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        denominator = lcm(denominator, boost::multiprecision::denominator(matrix(i, j)));
  std::vector<std::vector<Integer>> points;
  for (int k = 0; k < norm_.count(); ++k) {
    std::vector<Integer> integral;
    for (const double x : norm_.point(k)) integral.push_back(scaled_integer(x, vertex_bits));
    points.push_back(std::move(integral));
  }
  const Integer vertex_scale = Integer(1) << vertex_bits;
  const Integer weight_scale = Integer(1) << weight_bits;

  // target / (scale 2^48) = sum of weighted vertices + miss, both parts measured exactly.
  struct Measure {
    Rational weights;  // sum of |weights|
    Rational miss;     // l1 norm of the miss
  };
  const auto measure = [&](const std::vector<Integer>& target, const Integer& scale,
                           const PolytopeNorm::Combination& combination) {
    Integer weight_sum = 0;
    std::vector<Integer> miss;
    for (const Integer& x : target) miss.push_back(x * weight_scale);
    for (std::size_t b = 0; b < combination.points.size(); ++b) {
      const Integer weight = scaled_integer(combination.weights[b], weight_bits);
      weight_sum += abs(weight);
      const auto& v = points[static_cast<std::size_t>(combination.points[b])];
      for (std::size_t i = 0; i < miss.size(); ++i) miss[i] -= scale * weight * v[i];
    }
    Integer miss_sum = 0;
    for (const Integer& x : miss) miss_sum += abs(x);
    return Measure{Rational(weight_sum, weight_scale),
                   Rational(miss_sum, scale * vertex_scale * weight_scale)};
  };

  // ||e_j|| <= unit for all j: e_j = V w + miss gives ||e_j|| <= |w| + |miss|_1 unit, and total
  // misses below 1 prove that the vertices span.
  Rational most_weights = 0;
  Rational total_miss = 0;
  for (int j = 0; j < n; ++j) {
    std::vector<double> e(static_cast<std::size_t>(n), 0.0);
    std::vector<Integer> target(static_cast<std::size_t>(n), Integer(0));
    e[static_cast<std::size_t>(j)] = 1;
    target[static_cast<std::size_t>(j)] = vertex_scale;
    const auto combination = norm_.combine(e, 0);
    if (!std::isfinite(combination.norm)) return std::nullopt;
    const Measure m = measure(target, 1, combination);
    most_weights = std::max(most_weights, m.weights);
    total_miss += m.miss;
  }
  if (total_miss >= Rational(1) / 2) return std::nullopt;
  const Rational unit = most_weights / (1 - total_miss);

  Rational bound = 0;
  for (int k = 0; k < norm_.count(); ++k)
    for (std::size_t digit = 0; digit < scaled_.size(); ++digit) {
      if (must_stop(stop_)) return std::nullopt;
      std::vector<double> next = image(k, digit);
      for (double& x : next) x *= radius_;
      std::vector<Integer> target(static_cast<std::size_t>(n), Integer(0));
      const auto& matrix = local_->matrices[digit];
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
          target[static_cast<std::size_t>(i)] +=
              boost::multiprecision::numerator(matrix(i, j)) *
              (denominator / boost::multiprecision::denominator(matrix(i, j))) *
              points[static_cast<std::size_t>(k)][static_cast<std::size_t>(j)];
      const auto combination = norm_.combine(next, 0);
      if (!std::isfinite(combination.norm)) return std::nullopt;
      const Measure m = measure(target, denominator, combination);
      bound = std::max(bound, Rational(m.weights + m.miss * unit));
    }
  return bound;
}

std::optional<std::vector<std::vector<Rational>>> InvariantPolytope::exact_vertices() const {
  std::vector<std::vector<Rational>> vertices;
  for (const Origin& origin : origins_) {
    if (origin.parent < 0) {
      if (origin.exact.empty()) return std::nullopt;
      vertices.push_back(origin.exact);
      continue;
    }
    auto v = times(local_->matrices[static_cast<std::size_t>(origin.digit)],
                   vertices[static_cast<std::size_t>(origin.parent)]);
    for (Rational& x : v) x /= *exact_radius_;
    vertices.push_back(std::move(v));
  }
  return vertices;
}

bool InvariantPolytope::exactly_invariant() {
  if (!exact_radius_) return false;
  const auto vertices = exact_vertices();
  if (!vertices) return false;
  const int n = local_->size;
  for (int k = 0; k < norm_.count(); ++k)
    for (std::size_t digit = 0; digit < scaled_.size(); ++digit) {
      if (must_stop(stop_)) return false;
      const auto target = times(local_->matrices[digit], (*vertices)[static_cast<std::size_t>(k)]);
      const auto basis = norm_.combine(image(k, digit), 0).points;
      Matrix<Rational> columns(n, n);
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
          columns(i, j) = (*vertices)[static_cast<std::size_t>(basis[static_cast<std::size_t>(j)])]
                                     [static_cast<std::size_t>(i)];
      const auto weights = solve_unique(columns, target);
      if (!weights) return false;
      Rational sum = 0;
      for (const Rational& weight : *weights) sum += abs(weight);
      if (sum > *exact_radius_) return false;
    }
  return true;
}

}  // namespace arete
