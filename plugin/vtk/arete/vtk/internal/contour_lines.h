// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "arete/field/grid.h"

namespace arete::vtk {

/// The pieces of the line where a field is zero, linear between its samples, as pairs of places in
/// samples: {column, row} from the first sample. Values are held within -1 .. 1 first, so that
/// infinities do no harm. Of them only those where `within` (empty, or of the same size) is
/// negative. \pre at least 2 x 2 samples, no NaN.
[[nodiscard]] std::vector<std::array<std::array<double, 2>, 2>> zero_lines(
    const Grid<double>& field, const Grid<double>& within = {});

}  // namespace arete::vtk
