// SPDX-License-Identifier: MIT
#pragma once

#include "arete/field/georeference.h"

namespace arete {

/// How far one height field is from another, over the samples that both have.
struct HeightDifference {
  Index compared = 0;     ///< samples that both have; all else is NaN when there is none
  Index only_first = 0;   ///< samples missing in the second
  Index only_second = 0;  ///< samples missing in the first
  double rmse = 0;        ///< root of the mean squared difference
  double mean = 0;        ///< of second - first: the bias
  double mean_absolute = 0;
  double largest = 0;     ///< of |second - first|
  Index largest_row = 0;  ///< where that is, the first of several
  Index largest_col = 0;
};

/// Differences of heights of equally large fields; NaN and infinity are missing samples. Sums are
/// taken row by row and then over the rows, so that billions of samples lose no digits.
/// \throws InvalidField for fields of different extents.
[[nodiscard]] HeightDifference compare_heights(GridView<const double> first,
                                               GridView<const double> second);

/// The root of the mean squared difference of slope angles in degrees, and over how many samples:
/// those where both have a slope (see slope_degrees). NaN when there is none.
struct SlopeDifference {
  Index compared = 0;
  double rmse = 0;
};

/// `spacing`: distance of columns (x) and of rows (y), positive, in the unit of the heights.
/// \throws InvalidField for fields of different extents or a spacing that is not positive.
[[nodiscard]] SlopeDifference compare_slopes(GridView<const double> first,
                                             GridView<const double> second, WorldPoint spacing);

}  // namespace arete
