// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "arete/analysis/local_matrices.h"
#include "arete/analysis/stop.h"

namespace arete {

/// How hard to try. The defaults answer for every scheme of the catalogue in well under a second.
struct JsrOptions {
  int max_word_length = 24;
  int beam = 150;          ///< products kept per length in the search for a word
  int max_vertices = 700;  ///< of a polytope
  int max_dimension = 40;  ///< of the matrices; beyond it there are only norms, no words
  std::int64_t norm_budget = 2'000'000;  ///< for the exact norms of powers
  Stop stop;                             ///< bounds found so far are given when it says true
};

/// What is behind an upper bound.
enum class UpperProof { norm, polytope, exact_polytope };

/// lower <= JSR <= upper. Both ends are proved in exact arithmetic: the lower one by the Schur-Cohn
/// test of a word, the upper one by an exact norm of a power or by an invariant polytope whose
/// inclusions are verified exactly.
struct JsrBounds {
  Rational lower;
  Rational upper;
  Word word;                      ///< of the lower bound; 0 <= digits < arity
  std::optional<Rational> exact;  ///< the JSR itself, where it is a rational and proved equal
  UpperProof proof = UpperProof::norm;
  int power = 0;     ///< of the norm, for UpperProof::norm
  int vertices = 0;  ///< of the polytope, otherwise
  /// All products of length L are bounded by a constant times JSR^L: proved (true) or not decided.
  bool bounded = false;

  /// Whether the bounds agree to 1e-9 relative.
  [[nodiscard]] bool closed() const { return upper <= lower * (1 + Rational(1, 1'000'000'000)); }
};

/// The joint spectral radius of the operator S_q, JSR(q) = lim ||S_q^L||^{1/L}. q must not be zero.
[[nodiscard]] JsrBounds joint_spectral_radius(int arity, const LaurentPolynomial<Rational>& q,
                                              const JsrOptions& options = {});

/// Whether the matrices have no common invariant subspace, real or complex: they generate all n x n
/// matrices (Burnside). A true answer is proved (a rank modulo a prime); false means not shown.
/// Irreducible sets have bounded products at their JSR (Barabanov 1988).
[[nodiscard]] bool is_irreducible(const LocalMatrices& local);

}  // namespace arete
