// SPDX-License-Identifier: MIT
#pragma once

#include "arete/field/georeference.h"

namespace arete {

/// Slope angles of one row in degrees, by Horn's differences over 3 x 3 samples (Horn 1981), the
/// rule of gdaldem: NaN at the rim and wherever one of the nine samples is missing.
///
/// `spacing`: distance of columns (x) and of rows (y), in the unit of the heights; `out` holds cols
/// numbers. \throws InvalidField for a spacing that is not positive.
void slope_degrees(GridView<const double> heights, WorldPoint spacing, Index row, double* out);

}  // namespace arete
