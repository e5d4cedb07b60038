// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "arete/reverse/grid_reverse.h"

namespace arete {

/// Which samples of a grid exist: 1 or 0 for each, row by row. Empty: all of them.
using ValidSamples = std::vector<std::uint8_t>;

/// Marks the samples that are not finite and gives each a value, so that filters may run over it:
/// from the rim inwards, round by round, the mean of its known neighbours among the eight around.
/// Any value would come back exactly; this one makes details beside and inside holes small.
/// Returns nothing when no sample is missing. Cost: O(samples).
/// \throws InvalidField if no sample is finite.
template <class T>
[[nodiscard]] ValidSamples fill_missing(GridView<T> samples);

/// Which coarse samples of a reverse step exist: those whose nearest fine samples exist all, the
/// one at the coarse sample's place, or the two (four) around it.
[[nodiscard]] ValidSamples coarsened(const ValidSamples& fine, const ReverseLevel& rows,
                                     const ReverseLevel& cols);

/// The same after the first `steps` steps of a pyramid.
[[nodiscard]] ValidSamples coarsened(ValidSamples fine, const GridPyramid& pyramid, int steps);

}  // namespace arete
