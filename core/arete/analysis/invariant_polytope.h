// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "arete/analysis/local_matrices.h"
#include "arete/analysis/polytope_norm.h"
#include "arete/analysis/stop.h"

namespace arete {

/// A symmetric polytope P that the local matrices D_i map into gamma P, grown from the leading
/// eigenvectors of a word (Guglielmi, Protasov, "Exact computation of joint spectral
/// characteristics of linear operators", 2013). Then JSR <= gamma.
///
/// Growing uses floating point; what is claimed afterwards does not: the vertices are integers over
/// 2^48, and `verified_bound` recomputes in integer arithmetic how far each D_i v misses a given
/// combination of vertices and adds the miss to the bound. Rounding in the linear programs can make
/// the bound worse, never wrong.
class InvariantPolytope {
 public:
  /// radius > 0: the conjectured JSR, by which the matrices are divided while growing.
  /// If it is exact (a rational eigenvalue of every word), exact starting vectors are used.
  /// Told to stop, growing and proving fail.
  InvariantPolytope(const LocalMatrices& local, double radius,
                    const std::optional<Rational>& exact_radius, const std::vector<Word>& words,
                    Stop stop = {});

  /// Adds D_i v / radius of norm above 1 + tolerance until there is none (true) or there would be
  /// more than max_vertices, or a norm has exploded (false).
  bool grow(double tolerance, int max_vertices);

  [[nodiscard]] int vertices() const { return norm_.count(); }

  /// A rational gamma with D_i P inside gamma P for every i, proved in exact arithmetic; valid (but
  /// of use only) after grow has returned true. Nothing if the vertices do not verifiably span.
  [[nodiscard]] std::optional<Rational> verified_bound();

  /// Whether D_i P lies inside exact_radius P exactly, with all vertices recomputed as exact
  /// rationals. Then JSR = exact_radius (with the word's eigenvalue from below), and all products
  /// of length L are bounded by a constant times exact_radius^L. Needs an exact radius.
  [[nodiscard]] bool exactly_invariant();

 private:
  struct Origin {
    int parent = -1;  // vertex, or -1 for a start
    int digit = -1;
    std::vector<Rational> exact;  // the start itself, empty if it is known in floating point only
  };

  void add_start(const std::vector<double>& vector, std::vector<Rational> exact);
  void start_chain(const Word& word);
  void span_the_space();
  int add_vertex(std::vector<double> vector, Origin origin);
  [[nodiscard]] std::vector<double> image(int vertex, std::size_t digit) const;
  [[nodiscard]] std::optional<std::vector<std::vector<Rational>>> exact_vertices() const;

  const LocalMatrices* local_;
  double radius_;
  std::optional<Rational> exact_radius_;
  Stop stop_;
  std::vector<Matrix<double>> scaled_;  // D_i / radius
  std::vector<std::vector<double>> starts_;
  std::vector<Origin> start_origins_;
  PolytopeNorm norm_;
  std::vector<Origin> origins_;
};

/// A vector spanning the kernel of a - eigenvalue I if that kernel has dimension one.
[[nodiscard]] std::optional<std::vector<Rational>> exact_eigenvector(const Matrix<Rational>& a,
                                                                     const Rational& eigenvalue);

}  // namespace arete
