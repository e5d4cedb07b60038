// SPDX-License-Identifier: MIT
#include "arete/analysis/difference_theorems.h"

#include <algorithm>
#include <stdexcept>

#include "arete/algebra/characteristic_polynomial.h"
#include "arete/algebra/real_roots.h"
#include "arete/analysis/operator_power.h"

namespace arete {
namespace {

const char* const authors = " (Shen, Huang)";

void require_degree(const std::vector<Rational>& coefficients) {
  if (coefficients.size() != 2 && coefficients.size() != 3)
    throw std::invalid_argument("the statements are about 2 or 3 coefficients, not " +
                                std::to_string(coefficients.size()));
}

}  // namespace

Matrix<Rational> central_matrix(const std::vector<Rational>& coefficients, int m) {
  const auto d =
      LaurentPolynomial<Rational>(0, coefficients) * power(smoothing_factor<Rational>(2), m);
  const int size = static_cast<int>(coefficients.size()) + m;
  Matrix<Rational> matrix(size, size);
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j) matrix(i, j) = d[2 * i - j];
  return matrix;
}

std::vector<Rational> lemma_eigenvalues(const std::vector<Rational>& coefficients, int m) {
  require_degree(coefficients);
  if (m < 1) throw std::invalid_argument("the lemmas need m >= 1");
  std::vector<Rational> eigenvalues = coefficients;
  Rational scaled_sum = 0;
  for (const Rational& c : coefficients) scaled_sum += c;
  for (int j = 0; j < m; ++j) {
    eigenvalues.push_back(scaled_sum);
    scaled_sum *= 2;
  }
  std::sort(eigenvalues.begin(), eigenvalues.end());
  return eigenvalues;
}

TheoremResult difference_theorem(const std::vector<Rational>& coefficients) {
  require_degree(coefficients);
  Rational largest = 0;
  for (const Rational& c : coefficients) largest = std::max(largest, Rational(abs(c)));
  TheoremResult result;
  const bool first_degree = coefficients.size() == 2;
  result.name = std::string(first_degree ? "theorem 3" : "theorem 4") + authors;
  result.statement = first_degree ? "|a|, |b| < 1" : "|a|, |b|, |c| < 1";
  result.claims = 1;
  result.holds = largest < 1;
  result.values = {largest};
  result.sound = first_degree;
  if (!first_degree)
    result.remark =
        "false as printed: the joint spectral radius of the local matrices of az^2+bz+c must be "
        "below 1, not only the spectral radii of the single matrices";
  return result;
}

TheoremResult nonnegative_coefficients(const std::vector<Rational>& coefficients) {
  TheoremResult result;
  result.name = std::string("statement II)") + authors;
  result.statement = "all coefficients a0, a1, ... >= 0";
  result.claims = 1;
  result.nonnegative = coefficients;
  result.holds = std::all_of(coefficients.begin(), coefficients.end(),
                             [](const Rational& c) { return c >= 0; });
  return result;
}

TheoremResult lemma_result(const std::vector<Rational>& coefficients, int m) {
  TheoremResult result;
  const std::vector<Rational> eigenvalues = lemma_eigenvalues(coefficients, m);
  result.name = std::string(coefficients.size() == 2 ? "lemma 1" : "lemma 2") + authors;
  result.statement = "the central matrix has the eigenvalues ";
  for (const Rational& root : eigenvalues)
    result.statement += (&root == &eigenvalues.front() ? "" : ", ") + to_string(root);
  result.claims = -1;
  result.holds =
      characteristic_polynomial(central_matrix(coefficients, m)) == monic_polynomial(eigenvalues);
  return result;
}

DifferenceConvergence difference_convergence(const std::vector<Rational>& coefficients,
                                             const JsrOptions& options) {
  const LaurentPolynomial<Rational> c(0, coefficients);
  if (c.is_zero()) throw std::invalid_argument("a difference scheme needs a coefficient");
  DifferenceConvergence result;
  OperatorPower iterate(2, c);
  result.norm1 = iterate.norm();
  iterate.advance();
  result.norm2 = iterate.norm();
  const LocalMatrices local = local_matrices(2, c);
  const std::vector<Word> words = {{0},       {1},          {0, 1},      {0, 0, 1},
                                   {0, 1, 1}, {0, 0, 0, 1}, {0, 1, 1, 1}};
  for (const Word& word : words)
    if (word_reaches(local, word, 1)) result.violated.push_back(word);
  result.jsr = joint_spectral_radius(2, c, options);
  if (result.jsr.upper < 1) result.verdict = Verdict::certified;
  if (result.jsr.lower >= 1 || !result.violated.empty()) result.verdict = Verdict::refuted;
  return result;
}

std::vector<Rational> mixture(const std::vector<Rational>& first,
                              const std::vector<Rational>& second, const Rational& alpha) {
  if (first.size() != second.size())
    throw std::invalid_argument("only difference schemes of one degree can be mixed");
  std::vector<Rational> mixed;
  for (std::size_t i = 0; i < first.size(); ++i)
    mixed.push_back(alpha * first[i] + (1 - alpha) * second[i]);
  return mixed;
}

TheoremResult mixture_property(const std::vector<Rational>& first,
                               const std::vector<Rational>& second) {
  const TheoremResult one = difference_theorem(first);
  const TheoremResult two = difference_theorem(second);
  TheoremResult result;
  result.name = std::string("property 1") + authors;
  result.statement = "mixtures of two convergent difference schemes are convergent";
  result.holds = one.holds && two.holds;
  result.values = {one.values.front(), two.values.front()};
  result.sound = one.sound;
  if (!result.sound)
    result.remark = "false as printed: the true region of convergence is not convex";
  return result;
}

std::optional<MixedPair> refuting_mixture(const std::vector<Rational>& coefficients) {
  if (coefficients.size() != 3) return std::nullopt;
  if (difference_convergence(coefficients).verdict != Verdict::refuted) return std::nullopt;
  constexpr int reach = 8;
  const Rational unit = Rational(1) / 50;
  const auto shifted = [&](int c, int a) {
    return std::vector<Rational>{coefficients[0] + unit * c, coefficients[1] - unit * (a + c),
                                 coefficients[2] + unit * a};
  };
  const auto satisfies = [](const auto& d) { return difference_theorem(d).holds; };
  const auto converges = [](const auto& d) {
    return difference_convergence(d).verdict == Verdict::certified;
  };
  for (int c = 0; c <= reach; ++c)
    for (int a = -reach; a <= reach; ++a) {
      MixedPair pair{shifted(c, a), shifted(-c, -a)};
      if (satisfies(pair.first) && satisfies(pair.second) && converges(pair.first) &&
          converges(pair.second))
        return pair;
    }
  return std::nullopt;
}

}  // namespace arete
