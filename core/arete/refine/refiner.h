// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "arete/field/plane.h"
#include "arete/refine/axis_plan.h"
#include "arete/refine/detail.h"
#include "arete/refine/result_cells.h"
#include "arete/refine/row_pipe.h"
#include "arete/scheme/scheme.h"

namespace arete {

/// How a grid is refined; the defaults suit a height field.
struct RefineOptions {
  int levels = 1;
  Boundaries boundaries{};
  Alignment alignment = Alignment::nodes;
  /// 0: as many as the machine has. The result does not depend on it.
  int threads = 1;
  /// Filters after the last level (limit or derivative stencils), along x and along y.
  std::optional<Stencil> final_x{};
  std::optional<Stencil> final_y{};
  FinalResult final_result = FinalResult::samples;
  /// Random displacement of every level; none when empty, or when its relief is 0.
  std::optional<Detail> detail{};
};

/// Takes a tile of a result whose first sample is (row, col) of the result; only valid in the call.
template <class T>
using TakeTile = std::function<void(Index row, Index col, GridView<const T> tile)>;

/// Refines grids of one size by the tensor product of two 1-D schemes: all that does not depend on
/// the samples is prepared once. T is float or double; sums are taken in T. Thread-safe.
///
/// Missing samples (NaN, infinity) are allowed: a result is a NaN unless the input cell it lies in
/// (a closed unit square between four samples; at the rim of `cells` the nearest one) has four
/// valid corners, so the valid domain never grows. What valid results read beyond a hole is
/// continued from valid samples (see InputWindow), so holes hold no influence and planes stay.
template <class T>
class Refiner {
 public:
  /// \throws InvalidField if the plans cannot be made (see AxisPlan), or for numbers of the detail
  /// outside their ranges.
  Refiner(const Scheme& x, const Scheme& y, Extent input, const RefineOptions& options);
  Refiner(const Scheme& scheme, Extent input, const RefineOptions& options)
      : Refiner(scheme, scheme, input, options) {}
  /// From ready plans; `boundaries` of the options are those of the plans.
  Refiner(AxisPlan x, AxisPlan y, int threads = 1, const std::optional<Detail>& detail = {});

  [[nodiscard]] Extent input() const { return {y_.input_count(), x_.input_count()}; }
  [[nodiscard]] Extent output() const { return {y_.output_count(), x_.output_count()}; }
  [[nodiscard]] const AxisPlan& x() const { return x_; }
  [[nodiscard]] const AxisPlan& y() const { return y_; }

  /// Bytes of working memory for a band of that many result rows, all threads together, the band
  /// itself not counted.
  [[nodiscard]] double working_bytes(Index band_rows) const;

  /// Computes the result rows first_row, first_row + 1, ... into the rows of `band`, whose width
  /// is output().cols. Any cut into bands gives the same bits. Fastest when the rows of the band
  /// begin on cache lines (see Plane). A band larger than the cache is written past it.
  /// \throws InvalidField if the source or the band has another size than was prepared for.
  void refine_rows(const RowSource<T>& source, Index first_row, GridView<T> band) const;

  /// Computes the result rows `rows` (0-based, both included) tile by tile, in this thread, and
  /// gives each to `take` while it is in cache; the memory of a tile is used again for the next.
  /// Tiles have a few rows and the whole width, or for wide results a strip of it; each column
  /// comes from top to bottom. The same numbers as refine_rows.
  /// \throws InvalidField if the source or the rows do not fit; and what `take` throws.
  void for_each_tile(const RowSource<T>& source, IndexRange rows, const TakeTile<T>& take) const;

  /// The whole result.
  [[nodiscard]] Grid<T> operator()(GridView<const T> samples) const;
  /// The same in memory that is not touched before, with rows on cache lines: faster when it is
  /// large.
  [[nodiscard]] Plane<T> plane(GridView<const T> samples, Pages pages = Pages::huge) const;

 private:
  /// What the results of some rows have in common.
  struct Part {
    IndexRange rows;
    InputWindow<T> input;
    std::optional<LocalRelief<T>> relief;
  };

  void check(const RowSource<T>& source, IndexRange rows) const;
  [[nodiscard]] Index rows_a_part() const;
  [[nodiscard]] Part open_part(const RowSource<T>& source, IndexRange rows) const;
  [[nodiscard]] RowPipe<T> open_pipe(const Part& part, IndexRange columns,
                                     Workspace<T>& workspace) const;
  void refine_part(const RowSource<T>& source, Index first_row, GridView<T> rows, bool stream,
                   Workspace<T>& workspace) const;
  void clear_missing(const InputWindow<T>& input, Index first_row, Index first_col,
                     GridView<T> tile) const;
  [[nodiscard]] Boundaries boundaries() const { return {x_.boundary(), y_.boundary()}; }

  AxisPlan x_;
  AxisPlan y_;
  int threads_ = 1;
  Index reach_ = 0;
  PipeRules<T> rules_;
  ResultCells x_cells_;
  ResultCells y_cells_;
  std::vector<IndexRange> strips_;
  std::shared_ptr<const Displacement<T>> displacement_;  ///< null: no detail
};

/// One call: the grid refined by the scheme along both axes. Equal to Refiner's result.
template <class T>
[[nodiscard]] Grid<T> refine(GridView<const T> samples, const Scheme& scheme,
                             const RefineOptions& options = {});

template <class T>
[[nodiscard]] Grid<T> refine(const Grid<T>& samples, const Scheme& scheme,
                             const RefineOptions& options = {}) {
  return refine<T>(samples.view(), scheme, options);
}

/// Where the results lie in the world.
template <class T>
[[nodiscard]] Georeference refined(const Georeference& coarse, const Refiner<T>& refiner) {
  return refined(coarse, refiner.y().placement(), refiner.x().placement());
}

}  // namespace arete
