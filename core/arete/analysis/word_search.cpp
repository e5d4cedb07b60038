// SPDX-License-Identifier: MIT
#include "arete/analysis/word_search.h"

#include <algorithm>
#include <cmath>

#include "arete/analysis/eigen_double.h"

namespace arete {
namespace {

constexpr double tie = 1e-9;
constexpr std::size_t most_ties = 6;
constexpr double near_best = 2e-3;  // such words are tried in pairs
constexpr std::size_t most_near = 12;

struct Node {
  Word word;
  Matrix<double> product;
  double size = 0;  // norm^{1/length}
};

double frobenius_norm(const Matrix<double>& a) {
  double sum = 0;
  for (int i = 0; i < a.rows(); ++i)
    for (int j = 0; j < a.cols(); ++j) sum += a(i, j) * a(i, j);
  return std::sqrt(sum);
}

struct Rated {
  double value = 0;
  Word word;
};

// The near-best words met so far, best first, rotations merged.
void keep_near(std::vector<Rated>& near, double value, const Word& word) {
  if (!(value > 0) || value >= 1e300) return;
  if (!near.empty() && value < near.front().value * (1 - near_best)) return;
  if (near.size() == most_near && value <= near.back().value) return;
  Word turned = smallest_rotation(word);
  for (const Rated& rated : near)
    if (rated.word == turned) return;
  near.push_back({value, std::move(turned)});
  std::stable_sort(near.begin(), near.end(),
                   [](const Rated& a, const Rated& b) { return a.value > b.value; });
  if (near.size() > most_near) near.pop_back();
}

void keep(WordCandidates& best, double value, const Word& word) {
  if (!(value > 0) || value < best.value * (1 - tie)) return;
  if (value > best.value * (1 + tie)) best.words.clear();
  best.value = std::max(best.value, value);
  Word turned = smallest_rotation(word);
  if (best.words.size() < most_ties &&
      std::find(best.words.begin(), best.words.end(), turned) == best.words.end())
    best.words.push_back(std::move(turned));
}

// Long optimal words are often made of two shorter near-optimal ones.
void try_pairs(WordCandidates& best, std::vector<Rated> near,
               const std::vector<Matrix<double>>& matrices, int max_length, const Stop& stop) {
  for (bool improved = true; improved;) {
    improved = false;
    const std::vector<Rated> parts = near;
    for (const Rated& first : parts)
      for (const Rated& second : parts) {
        if (must_stop(stop)) return;
        const std::size_t length = first.word.size() + second.word.size();
        if (length > static_cast<std::size_t>(max_length)) continue;
        Word turned = second.word;
        for (std::size_t r = 0; r < turned.size(); ++r) {
          std::rotate(turned.begin(), turned.begin() + 1, turned.end());
          Word word = first.word;
          word.insert(word.end(), turned.begin(), turned.end());
          if (!is_primitive(word)) continue;
          auto product = Matrix<double>::identity(matrices.front().rows());
          for (const int digit : word)
            product = matrices[static_cast<std::size_t>(digit)] * product;
          const double value =
              std::pow(approximate_spectral_radius(product), 1.0 / static_cast<double>(length));
          improved = improved || value > best.value * (1 + tie);
          keep(best, value, word);
          keep_near(near, value, word);
        }
      }
  }
}

}  // namespace

WordCandidates search_words(const std::vector<Matrix<double>>& matrices, int max_length, int beam,
                            const Stop& stop) {
  WordCandidates best;
  std::vector<Rated> near;
  std::vector<Node> level = {{{}, Matrix<double>::identity(matrices.front().rows()), 1}};
  for (int length = 1; length <= max_length && !level.empty(); ++length) {
    std::vector<Node> next;
    for (const Node& node : level) {
      if (must_stop(stop)) return best;
      for (std::size_t digit = 0; digit < matrices.size(); ++digit) {
        Node child{node.word, matrices[digit] * node.product, 0};
        child.word.push_back(static_cast<int>(digit));
        child.size = std::pow(frobenius_norm(child.product), 1.0 / length);
        if (!(child.size > 0) || child.size < best.value * (1 - tie)) continue;
        if (is_primitive(child.word)) {
          const double radius = approximate_spectral_radius(child.product);
          const double value = std::pow(radius, 1.0 / length);
          keep(best, value, child.word);
          keep_near(near, value, child.word);
        }
        next.push_back(std::move(child));
      }
    }
    std::erase_if(next, [&best](const Node& node) { return node.size < best.value * (1 - tie); });
    const auto count = std::min(next.size(), static_cast<std::size_t>(beam));
    std::partial_sort(next.begin(), next.begin() + static_cast<std::ptrdiff_t>(count), next.end(),
                      [](const Node& a, const Node& b) {
                        return a.size != b.size ? a.size > b.size : a.word < b.word;
                      });
    next.resize(count);
    level = std::move(next);
  }
  if (max_length > 8) try_pairs(best, near, matrices, max_length, stop);
  std::stable_sort(best.words.begin(), best.words.end(), [](const Word& a, const Word& b) {
    return a.size() != b.size() ? a.size() < b.size() : a < b;
  });
  return best;
}

}  // namespace arete
