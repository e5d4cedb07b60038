// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "arete/field/grid.h"
#include "cli/map_plane.h"

namespace arete::cli {

/// A region that a paper prints, over a plane of parameters.
struct PrintedRegion {
  enum class Extent { nowhere, inside, everywhere, line, points };

  std::string name;     ///< of the statement: `theorem 1 (Zhao, Peng, Ye), C^0`
  Grid<double> margin;  ///< region_margin, from the first to the last value of both axes
  /// Where the statement holds: its inequalities may hold inside a region of the plane, but an
  /// equality that is no identity on the plane leaves a line of it, two leave points.
  Extent extent = Extent::nowhere;
  Grid<double> equality;  ///< for Extent::line: the residual that vanishes on it
};

/// The regions of the statements about the family, sampled finely enough for smooth outlines.
[[nodiscard]] std::vector<PrintedRegion> printed_regions(const MapPlane& plane, const MapRange& x,
                                                         const MapRange& y);

}  // namespace arete::cli
