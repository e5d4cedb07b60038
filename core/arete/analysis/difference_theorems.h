// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "arete/analysis/theorem.h"

namespace arete {

/// The statements of Shen, Huang ("A class of curve subdivision schemes with several parameters")
/// about the difference schemes D(z) = c(z) (1+z)^m, c(1) = 2^-m, with the coefficients of c
/// ascending: [b, a] for c = a z + b, [c, b, a] for c = a z^2 + b z + c.
///
/// "D is convergent" (its powers tend to zero) is equivalent to JSR(c) < 1, because the factors
/// (1+z) only add 1/2, 1/4, ... to the spectrum. The paper asks for the spectral radius of one
/// matrix instead:
/// - theorem 3, degree 1: convergent iff |a|, |b| < 1. True.
/// - theorem 4, degree 2: convergent if |a|, |b|, |c| < 1. FALSE for every m >= 1: products of the
///   two local matrices may grow all the same, e.g. (a, b, c) = (1/4, 19/20, -19/20), m = 2.
/// - property 1: mixtures alpha D1 + (1-alpha) D2, 0 <= alpha <= 1, of convergent ones converge.
///   FALSE for m = 2, 3, 4: the true region is not convex.
/// - II), any degree: convergent if all coefficients are >= 0. True.
/// - "at least C^1" for the schemes ((1+z)/2)(1+z) D(z), where D is convergent. True.

/// The central matrix (D_{2i-j}), i, j = 0..degree of D, whose spectral radius the paper uses.
[[nodiscard]] Matrix<Rational> central_matrix(const std::vector<Rational>& coefficients, int m);

/// Its eigenvalues by lemma 1 (degree 1) and lemma 2 (degree 2), ascending: the coefficients, and
/// 2^j c(1) for j = 0..m-1. Both lemmas are true, for any c(1).
/// \throws std::invalid_argument for another degree (the paper's extension to higher degree "as in
/// the lemmas" does not hold) or m < 1.
[[nodiscard]] std::vector<Rational> lemma_eigenvalues(const std::vector<Rational>& coefficients,
                                                      int m);

/// Theorem 3 or 4 by the number of coefficients (2 or 3); the value is the largest |coefficient|,
/// `claims` the order of the scheme raised once. \throws std::invalid_argument for another degree.
[[nodiscard]] TheoremResult difference_theorem(const std::vector<Rational>& coefficients);

/// Statement II), for any number of coefficients.
[[nodiscard]] TheoremResult nonnegative_coefficients(const std::vector<Rational>& coefficients);

/// Lemma 1 or 2 for this central matrix: "holds" if its characteristic polynomial has exactly the
/// roots of lemma_eigenvalues. \throws as that does.
[[nodiscard]] TheoremResult lemma_result(const std::vector<Rational>& coefficients, int m);

/// The truth: whether JSR(c) < 1, certified or refuted by proved bounds.
struct DifferenceConvergence {
  Verdict verdict = Verdict::undecided;
  JsrBounds jsr;  ///< of c
  /// Which of the words 0, 1, 01, 001, 011, 0001, 0111 have a spectral radius >= 1 (exact). Any one
  /// refutes convergence; for degree 2 having none was found sufficient in all cases tried.
  std::vector<Word> violated;
  Rational norm1;  ///< ||S_c||
  Rational norm2;  ///< ||S_c^2||
};
[[nodiscard]] DifferenceConvergence difference_convergence(
    const std::vector<Rational>& coefficients, const JsrOptions& options = {});

/// alpha first + (1 - alpha) second, property 1's mixture. Equal sizes.
[[nodiscard]] std::vector<Rational> mixture(const std::vector<Rational>& first,
                                            const std::vector<Rational>& second,
                                            const Rational& alpha);

/// Property 1 for two schemes: it holds (as printed) if both satisfy theorem 3 or 4; its conclusion
/// is wrong where the mixture is refuted. claims = 0: convergence of the difference scheme.
[[nodiscard]] TheoremResult mixture_property(const std::vector<Rational>& first,
                                             const std::vector<Rational>& second);

/// Two difference schemes of degree 2 that satisfy theorem 4, are both proved convergent, and have
/// these coefficients as their mean, searched on a lattice around them. Nothing if these
/// coefficients are not refuted themselves (then they prove nothing against property 1), or if
/// there is no such pair near them.
struct MixedPair {
  std::vector<Rational> first;
  std::vector<Rational> second;
};
[[nodiscard]] std::optional<MixedPair> refuting_mixture(const std::vector<Rational>& coefficients);

}  // namespace arete
