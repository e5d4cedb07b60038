// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "arete/field/boundary.h"
#include "arete/reverse/axis_reverse.h"
#include "arete/scheme/scheme.h"

namespace arete {

struct GridReverseOptions {
  int levels = 1;
  ReverseMode mode = ReverseMode::least_squares;
  Boundaries boundaries;
  /// 0: as many as the machine has. The result does not depend on it.
  int threads = 1;
};

/// What one reverse step takes out of a grid: the three blocks beside the coarse one. The first
/// letter is the axis from row to row, the second along a row; c coarse, d detail.
template <class T>
struct GridDetails {
  Grid<T> cd;
  Grid<T> dc;
  Grid<T> dd;

  /// The blocks one after the other, for what treats all details alike.
  [[nodiscard]] std::vector<Grid<T>*> blocks() { return {&cd, &dc, &dd}; }
  [[nodiscard]] std::vector<const Grid<T>*> blocks() const { return {&cd, &dc, &dd}; }
};

/// A grid taken apart.
template <class T>
struct GridDecomposition {
  Grid<T> coarse;
  std::vector<GridDetails<T>> details;  ///< of step 1 (the finest), 2, ...
};

/// Sizes and places of a grid's reverse steps, without samples.
class GridPyramid {
 public:
  /// \throws InvalidField for negative levels, an empty grid, or boundary `none`.
  GridPyramid(const Mask& mask, Extent fine, const GridReverseOptions& options);

  [[nodiscard]] int levels() const { return static_cast<int>(rows_.size()); }
  /// Of the grid after `step` reverse steps; 0 is the input.
  [[nodiscard]] Extent extent(int step) const;
  /// Where its rows and columns lie among the input's.
  [[nodiscard]] AxisPlacement row_placement(int step) const;
  [[nodiscard]] AxisPlacement col_placement(int step) const;
  /// The axes of the step that leads from extent(step) to extent(step + 1).
  [[nodiscard]] const ReverseLevel& rows(int step) const { return rows_.at(index(step)); }
  [[nodiscard]] const ReverseLevel& cols(int step) const { return cols_.at(index(step)); }

 private:
  static std::size_t index(int step) { return static_cast<std::size_t>(step); }

  Extent fine_;
  std::vector<ReverseLevel> rows_;
  std::vector<ReverseLevel> cols_;
};

/// Takes a grid apart: along every column, then along every row, level by level. All samples must
/// be finite (see missing_samples.h for those that are not). T is float or double.
///
/// Open axes: coarse and details together are exactly the samples of the input. Memory: the
/// results, and a copy of the grid. Cost: O(samples), for either mode; see docs/reverse.md.
/// \throws InvalidField, InvalidScheme as AxisReverse and GridPyramid.
template <class T>
[[nodiscard]] GridDecomposition<T> decompose_grid(GridView<const T> samples, const Scheme& scheme,
                                                  const GridReverseOptions& options);

/// Puts the coarsest `steps` levels back; all of them give the input again to a few rounding
/// errors (exactly, for dyadic samples and a dyadic scheme in mode local).
/// `fine` is the extent of the input. \throws InvalidField if sizes or steps do not fit together.
template <class T>
[[nodiscard]] Grid<T> reconstruct_grid(const GridDecomposition<T>& parts, Extent fine,
                                       const Scheme& scheme, const GridReverseOptions& options,
                                       int steps);

}  // namespace arete
