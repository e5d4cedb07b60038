// SPDX-License-Identifier: MIT
#include "arete/analysis/joint_spectral_radius.h"

#include <cmath>

#include "arete/algebra/real_roots.h"
#include "arete/algebra/schur_cohn.h"
#include "arete/analysis/invariant_polytope.h"
#include "arete/analysis/operator_power.h"
#include "arete/analysis/word_search.h"

namespace arete {
namespace {

constexpr int largest_exact_word = 40;  // no words for larger matrices: exact tests take too long

// The rational of smallest denominator in [lowest, highest], 0 < lowest <= highest (Stern, Brocot).
Rational simplest_between(const Rational& lowest, const Rational& highest) {
  const Integer whole = floor(lowest);
  if (Rational(whole) == lowest) return lowest;
  if (Rational(whole + 1) <= highest) return Rational(whole + 1);
  const Rational rest = simplest_between(1 / (highest - whole), 1 / (lowest - whole));
  return whole + 1 / rest;
}

std::optional<std::vector<Matrix<double>>> rounded(const LocalMatrices& local) {
  std::vector<Matrix<double>> result;
  double most = 0;
  for (const auto& matrix : local.matrices) {
    Matrix<double> copy(local.size, local.size);
    for (int i = 0; i < local.size; ++i)
      for (int j = 0; j < local.size; ++j) {
        copy(i, j) = to_double(matrix(i, j));
        most = std::max(most, std::abs(copy(i, j)));
        if (!std::isfinite(copy(i, j))) return std::nullopt;
      }
    result.push_back(std::move(copy));
  }
  if (!(most > 1e-60 && most < 1e60)) return std::nullopt;
  return result;
}

void take_upper(JsrBounds& bounds, const Rational& upper, UpperProof proof, int power,
                int vertices) {
  if (upper >= bounds.upper) return;
  bounds.upper = upper;
  bounds.proof = proof;
  bounds.power = power;
  bounds.vertices = vertices;
}

// A rational u >= norm^{1/power}, tight to about 1e-14.
std::optional<Rational> root_above(const Rational& norm, int power) {
  if (power == 1) return norm;
  const double root = std::pow(to_double(norm), 1.0 / power);
  if (!std::isfinite(root) || root <= 0) return std::nullopt;
  for (double slack = 1e-15; slack < 1e-9; slack *= 4) {
    Rational candidate(root * (1 + slack));
    if (arete::power(candidate, static_cast<unsigned>(power)) >= norm) return candidate;
  }
  return std::nullopt;
}

void bound_by_norms(JsrBounds& bounds, int arity, const LaurentPolynomial<Rational>& q,
                    std::int64_t budget, const Stop& stop) {
  OperatorPower iterate(arity, q);
  bounds.upper = iterate.norm();
  bounds.power = 1;
  for (std::int64_t cost = iterate.cost_of_next();
       cost <= budget && iterate.power() < 16 && !must_stop(stop); cost = iterate.cost_of_next()) {
    budget -= cost;
    iterate.advance();
    if (const auto root = root_above(iterate.norm(), iterate.power()))
      take_upper(bounds, *root, UpperProof::norm, iterate.power(), 0);
  }
}

bool has_eigenvalue(const std::vector<Rational>& characteristic, const Rational& value) {
  return value_at(characteristic, value) == 0 || value_at(characteristic, -value) == 0;
}

// The exact averaged spectral radius of the word, if it is a rational of moderate size.
std::optional<Rational> rational_radius(const LocalMatrices& local, const Word& word,
                                        double value) {
  const Rational nice =
      simplest_between(Rational(value * (1 - 1e-11)), Rational(value * (1 + 1e-11)));
  if (boost::multiprecision::denominator(nice) > 50'000'000) return std::nullopt;
  const auto characteristic = characteristic_polynomial(word_product(local, word));
  if (!has_eigenvalue(characteristic, power(nice, static_cast<unsigned>(word.size()))))
    return std::nullopt;
  return nice;
}

// The largest double u with u^power <= value, to about 1e-14; 0 if there is none.
Rational root_below(const Rational& value, int power) {
  const double root = std::pow(to_double(value), 1.0 / power);
  for (double slack = 1e-16; slack < 1e-9; slack *= 4) {
    Rational candidate(root * (1 - slack));
    if (arete::power(candidate, static_cast<unsigned>(power)) <= value) return candidate;
  }
  return 0;
}

// value^length is rounded down to few bits, because its powers scale a characteristic polynomial;
// the fewer the larger the matrix, or the exact test would take minutes.
void prove_lower(JsrBounds& bounds, const LocalMatrices& local, const Word& word, double value) {
  const int length = static_cast<int>(word.size());
  const std::vector<Rational> characteristic = characteristic_polynomial(word_product(local, word));
  const double first_slack = local.size <= 24 ? 1e-14 : 1e-7;
  for (double slack = first_slack; slack < 1e-1; slack *= 16) {
    const double radius = std::pow(value, length) * (1 - length * slack);
    const int bits = std::min(53, static_cast<int>(2 - std::log2(length * slack)));
    int exponent = 0;
    const double mantissa = std::frexp(radius, &exponent);
    const Rational bound(std::ldexp(std::floor(std::ldexp(mantissa, bits)), exponent - bits));
    const Rational candidate = root_below(bound, length);
    if (candidate <= bounds.lower) return;
    std::vector<Rational> scaled = characteristic;
    Rational factor = 1;
    for (Rational& coefficient : scaled) {
      coefficient *= factor;
      factor *= bound;
    }
    if (is_schur_stable(std::move(scaled))) continue;
    bounds.lower = candidate;
    bounds.word = word;
    return;
  }
}

struct Candidates {
  WordCandidates found;
  std::optional<Rational> exact;  // the value, if rational, of all the words
};

Candidates find_words(JsrBounds& bounds, const LocalMatrices& local,
                      const std::vector<Matrix<double>>& matrices, int max_length, int beam,
                      const Stop& stop) {
  Candidates candidates{search_words(matrices, max_length, beam, stop), std::nullopt};
  const WordCandidates& found = candidates.found;
  if (found.words.empty() || must_stop(stop)) return candidates;
  candidates.exact = rational_radius(local, found.words.front(), found.value);
  for (const Word& word : found.words)
    if (candidates.exact && rational_radius(local, word, found.value) != candidates.exact)
      candidates.exact.reset();
  if (candidates.exact && *candidates.exact > bounds.lower) {
    bounds.lower = *candidates.exact;
    bounds.word = found.words.front();
  } else {
    prove_lower(bounds, local, found.words.front(), found.value);
  }
  return candidates;
}

// The exact test of a word takes about n^4 length^2 units of time.
int longest_word(int size, const JsrOptions& options) {
  return std::min(options.max_word_length, size <= 24 ? 24 : size <= 32 ? 4 : 1);
}

// True once the bounds have met.
bool bound_by_polytope(JsrBounds& bounds, const LocalMatrices& local, const Candidates& candidates,
                       double tolerance, const JsrOptions& options) {
  const int max_vertices = options.max_vertices;
  if (candidates.exact && tolerance < 1e-9) {
    InvariantPolytope polytope(local, candidates.found.value, candidates.exact,
                               candidates.found.words, options.stop);
    if (polytope.grow(1e-11, max_vertices) && polytope.exactly_invariant()) {
      take_upper(bounds, *candidates.exact, UpperProof::exact_polytope, 0, polytope.vertices());
      bounds.exact = candidates.exact;
      bounds.bounded = true;
      return true;
    }
  }
  InvariantPolytope polytope(local, candidates.found.value, std::nullopt, candidates.found.words,
                             options.stop);
  if (!polytope.grow(tolerance, max_vertices)) return false;
  if (const auto bound = polytope.verified_bound())
    take_upper(bounds, *bound, UpperProof::polytope, 0, polytope.vertices());
  return bounds.closed();
}

// Where no polytope closes tightly, loose ones do: tighter and tighter until one does not.
void narrow_by_polytopes(JsrBounds& bounds, const LocalMatrices& local,
                         const Candidates& candidates, const JsrOptions& options) {
  for (const double tolerance : {1e-1, 1e-2, 1e-3, 1e-4, 1e-6}) {
    if (bounds.upper <= bounds.lower * (1 + Rational(tolerance))) continue;
    const Rational before = bounds.upper;
    bound_by_polytope(bounds, local, candidates, tolerance, options);
    if (bounds.upper == before) return;
  }
}

}  // namespace

JsrBounds joint_spectral_radius(int arity, const LaurentPolynomial<Rational>& q,
                                const JsrOptions& options) {
  const LocalMatrices local = local_matrices(arity, q);
  JsrBounds bounds;
  bound_by_norms(bounds, arity, q, options.norm_budget, options.stop);
  const Rational step_norm = OperatorPower(arity, q).norm();
  // The q(1)^L of a unit impulse spreads over O(m^L) samples, so JSR >= |q(1)|/m.
  bounds.lower = abs(q.sum()) / arity;

  const auto matrices = local.size <= largest_exact_word && !must_stop(options.stop)
                            ? rounded(local)
                            : std::optional<std::vector<Matrix<double>>>();
  if (matrices) {
    const double work = std::pow(local.size, 3) * arity * options.max_word_length;
    const int beam = std::clamp(static_cast<int>(4e7 / work), 8, options.beam);
    const int longest = longest_word(local.size, options);
    Candidates candidates =
        find_words(bounds, local, *matrices, std::min(longest, 8), beam, options.stop);
    if (candidates.exact == step_norm && candidates.exact) {
      bounds.exact = step_norm;
      bounds.bounded = true;
      take_upper(bounds, step_norm, UpperProof::norm, 1, 0);
    } else if (local.size <= options.max_dimension && options.max_vertices > 0 &&
               !candidates.found.words.empty()) {
      bool met = bound_by_polytope(bounds, local, candidates, 1e-10, options);
      if (!met && longest > 8 && !must_stop(options.stop)) {
        const Candidates longer = find_words(bounds, local, *matrices, longest, beam, options.stop);
        if (longer.found.value > candidates.found.value * (1 + 1e-10)) {
          candidates = longer;
          met = bound_by_polytope(bounds, local, candidates, 1e-10, options);
        }
      }
      if (!met) narrow_by_polytopes(bounds, local, candidates, options);
    }
  }
  if (bounds.lower == bounds.upper && !bounds.exact) bounds.exact = bounds.lower;
  if (!bounds.bounded && !must_stop(options.stop)) bounds.bounded = is_irreducible(local);
  return bounds;
}

}  // namespace arete
