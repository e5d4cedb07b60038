// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "arete/algebra/matrix.h"
#include "arete/analysis/stop.h"
#include "arete/analysis/word.h"

namespace arete {

/// Words whose averaged spectral radius is likely to be the joint spectral radius.
struct WordCandidates {
  double value = 0;  ///< the largest spectral_radius(word)^{1/length} found, in floating point
  std::vector<Word> words;  ///< the words that have it (to 1e-9), shortest first, rotations merged
};

/// Gripenberg's branch and bound ("Computing the joint spectral radius", 1996) made greedy:
/// products are extended one matrix at a time, those with norm^{1/length} below the best value so
/// far cannot lead to a better one soon and are dropped, and of the rest only the `beam` largest in
/// norm go on. For max_length > 8 pairs of near-optimal words are tried as well. Cost O(max_length
/// beam m n^3). When told to stop it gives what it has found.
[[nodiscard]] WordCandidates search_words(const std::vector<Matrix<double>>& matrices,
                                          int max_length, int beam, const Stop& stop = {});

}  // namespace arete
