// SPDX-License-Identifier: MIT
#pragma once

#include "arete/gdal/raster.h"

namespace arete::cli {

/// Heights of two rasters at the places where both have a sample.
struct CommonLattice {
  Grid<double> first;
  Grid<double> second;
  Georeference place;
};

/// How the finer of two rasters holds the samples of the other: sample (row, col) of the coarser
/// is sample (row_step * row + first_row, ...) of the finer.
struct LatticeMatch {
  bool second_is_finer = true;
  Index row_step = 1, col_step = 1;
  Index first_row = 0, first_col = 0;
};

/// Matches two rasters: equal lattices, parts of one, or every n-th sample of one (a control grid
/// and its refinement). Without georeferences samples are matched by their numbers.
/// \throws Failure if they name different reference systems, only one has a georeference, or
/// samples of one lie between those of the other by more than a thousandth.
[[nodiscard]] LatticeMatch match_lattices(const gdal::Raster& first, const gdal::Raster& second);

/// The samples of band `band` (from 1) of both where they overlap.
/// \throws Failure as match_lattices, or if they do not overlap or need more than `max_memory`.
[[nodiscard]] CommonLattice read_common(const gdal::Raster& first, const gdal::Raster& second,
                                        int band, double max_memory);

/// Distance of columns and rows at the middle of the raster in metres where coordinates are
/// degrees, otherwise in their own unit.
[[nodiscard]] WorldPoint ground_spacing(const Georeference& place, Extent extent, bool degrees);

}  // namespace arete::cli
