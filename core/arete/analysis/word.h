// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace arete {

/// A product of local matrices (local_matrices.h), by their digits; the first digit is applied
/// first.
using Word = std::vector<int>;

/// `0001`; digits above 9 are set off by points: `3.12.0`.
[[nodiscard]] inline std::string to_text(const Word& word) {
  const bool wide = std::any_of(word.begin(), word.end(), [](int digit) { return digit > 9; });
  std::string text;
  for (const int digit : word) {
    if (wide && !text.empty()) text += '.';
    text += std::to_string(digit);
  }
  return text;
}

/// The lexicographically smallest rotation; rotations have the same spectral radius.
[[nodiscard]] inline Word smallest_rotation(const Word& word) {
  Word best = word;
  Word turned = word;
  for (std::size_t i = 1; i < word.size(); ++i) {
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
    best = std::min(best, turned);
  }
  return best;
}

/// Whether the word is not a power of a shorter one.
[[nodiscard]] inline bool is_primitive(const Word& word) {
  for (std::size_t period = 1; period < word.size(); ++period)
    if (word.size() % period == 0 &&
        std::equal(word.begin() + static_cast<std::ptrdiff_t>(period), word.end(), word.begin()))
      return false;
  return true;
}

}  // namespace arete
