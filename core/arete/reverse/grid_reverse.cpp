// SPDX-License-Identifier: MIT
#include "arete/reverse/grid_reverse.h"

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace arete {
namespace {

// Lanes worked on at a time: enough to fill vector registers, few enough to stay in cache. Columns
// are taken in wider runs, so that every visit of a row reads whole pages of it.
constexpr Index rows_at_a_time = 32;
constexpr Index columns_at_a_time = 256;

// Calls work(first, count) for runs of `width` lanes that cover 0..lanes-1.
template <class Work>
void for_runs(Index lanes, Index width, int threads, Work&& work) {
  const Index runs = ceil_divide(lanes, width);
  const auto run = [&](Index i) {
    const Index first = i * width;
    work(first, std::min(width, lanes - first));
  };
  if (threads == 1) {
    for (Index i = 0; i < runs; ++i) run(i);
    return;
  }
  tbb::task_arena arena(threads > 0 ? threads : tbb::info::default_concurrency());
  arena.execute([&] { tbb::parallel_for(Index{0}, runs, run); });
}

template <class T>
Lines<T> columns_of(Grid<T>& grid, Index first, Index count) {
  return {grid.samples().data() + first, grid.rows(), count, grid.cols()};
}
template <class T>
Lines<const T> columns_of(GridView<const T> grid, Index first, Index count) {
  return {grid.row(0) + first, grid.rows(), count, grid.stride()};
}

// Rows first.. of the grid, turned so that samples of a row follow each other line by line. A few
// columns at a time, so that what is written lies together.
constexpr Index turned_at_a_time = 8;

template <class T>
void turn_in(GridView<const T> grid, Index first, Lines<T> lines) {
  for (Index from = 0; from < lines.count; from += turned_at_a_time) {
    const Index to = std::min(from + turned_at_a_time, lines.count);
    for (Index lane = 0; lane < lines.lanes; ++lane) {
      const T* row = grid.row(first + lane);
      for (Index c = from; c < to; ++c) lines[c][lane] = row[c];
    }
  }
}
template <class T>
void turn_out(Lines<const T> lines, Grid<T>& grid, Index first) {
  for (Index from = 0; from < lines.count; from += turned_at_a_time) {
    const Index to = std::min(from + turned_at_a_time, lines.count);
    for (Index lane = 0; lane < lines.lanes; ++lane) {
      T* row = grid.row(first + lane);
      for (Index c = from; c < to; ++c) row[c] = lines[c][lane];
    }
  }
}

template <class T>
void analyse_columns(const AxisReverse<T>& axis, GridView<const T> fine, Grid<T>& coarse,
                     Grid<T>& details, int threads) {
  for_runs(fine.cols(), columns_at_a_time, threads, [&](Index first, Index count) {
    axis.analyse(columns_of(fine, first, count), columns_of(coarse, first, count),
                 columns_of(details, first, count));
  });
}

template <class T>
void synthesise_columns(const AxisReverse<T>& axis, const Grid<T>& coarse, const Grid<T>& details,
                        Grid<T>& fine, int threads) {
  for_runs(fine.cols(), columns_at_a_time, threads, [&](Index first, Index count) {
    axis.synthesise(columns_of(coarse.view(), first, count),
                    columns_of(details.view(), first, count), columns_of(fine, first, count));
  });
}

template <class T>
void analyse_rows(const AxisReverse<T>& axis, const Grid<T>& fine, Grid<T>& coarse,
                  Grid<T>& details, int threads) {
  for_runs(fine.rows(), rows_at_a_time, threads, [&](Index first, Index count) {
    LineBuffer<T> in(fine.cols(), count);
    LineBuffer<T> low(coarse.cols(), count);
    LineBuffer<T> high(details.cols(), count);
    turn_in(fine.view(), first, in.lines());
    axis.analyse(in.lines(), low.lines(), high.lines());
    turn_out<T>(low.lines(), coarse, first);
    turn_out<T>(high.lines(), details, first);
  });
}

template <class T>
void synthesise_rows(const AxisReverse<T>& axis, const Grid<T>& coarse, const Grid<T>& details,
                     Grid<T>& fine, int threads) {
  for_runs(fine.rows(), rows_at_a_time, threads, [&](Index first, Index count) {
    LineBuffer<T> low(coarse.cols(), count);
    LineBuffer<T> high(details.cols(), count);
    LineBuffer<T> out(fine.cols(), count);
    turn_in(coarse.view(), first, low.lines());
    turn_in(details.view(), first, high.lines());
    axis.synthesise(low.lines(), high.lines(), out.lines());
    turn_out<T>(out.lines(), fine, first);
  });
}

void check_extent(Extent actual, Extent wanted, const char* what, int step) {
  if (!(actual == wanted))
    throw InvalidField(std::string(what) + " of step " + std::to_string(step + 1) + " has " +
                       std::to_string(actual.rows) + " x " + std::to_string(actual.cols) +
                       " samples where " + std::to_string(wanted.rows) + " x " +
                       std::to_string(wanted.cols) + " belong; it is of another decomposition");
}

}  // namespace

GridPyramid::GridPyramid(const Mask& mask, Extent fine, const GridReverseOptions& options)
    : fine_(fine) {
  if (options.levels < 0)
    throw InvalidField("levels = " + std::to_string(options.levels) +
                       " is negative; give 0 or more");
  for (int step = 0; step < options.levels; ++step) {
    rows_.emplace_back(mask, fine.rows, options.boundaries.y);
    cols_.emplace_back(mask, fine.cols, options.boundaries.x);
    fine = {rows_.back().coarse_count, cols_.back().coarse_count};
  }
}

Extent GridPyramid::extent(int step) const {
  if (step == 0) return fine_;
  return {rows(step - 1).coarse_count, cols(step - 1).coarse_count};
}

AxisPlacement GridPyramid::row_placement(int step) const {
  AxisPlacement place{fine_.rows, 0, 1};
  for (int i = 0; i < step; ++i) place = composed(place, rows(i).placement());
  return place;
}

AxisPlacement GridPyramid::col_placement(int step) const {
  AxisPlacement place{fine_.cols, 0, 1};
  for (int i = 0; i < step; ++i) place = composed(place, cols(i).placement());
  return place;
}

template <class T>
GridDecomposition<T> decompose_grid(GridView<const T> samples, const Scheme& scheme,
                                    const GridReverseOptions& options) {
  const GridPyramid pyramid(scheme.mask(), samples.extent(), options);
  GridDecomposition<T> result;
  if (options.levels == 0) {
    result.coarse = Grid<T>(samples.extent());
    for (Index r = 0; r < samples.rows(); ++r)
      std::copy_n(samples.row(r), samples.cols(), result.coarse.row(r));
  }
  for (int step = 0; step < options.levels; ++step) {
    const Grid<T> before = std::move(result.coarse);
    const GridView<const T> fine = step == 0 ? samples : before.view();
    const AxisReverse<T> y(scheme.mask(), fine.rows(), options.boundaries.y, options.mode);
    const AxisReverse<T> x(scheme.mask(), fine.cols(), options.boundaries.x, options.mode);
    Grid<T> low({y.coarse_count(), fine.cols()});
    Grid<T> high({y.detail_count(), fine.cols()});
    analyse_columns(y, fine, low, high, options.threads);
    result.coarse = Grid<T>({y.coarse_count(), x.coarse_count()});
    GridDetails<T> details{Grid<T>({y.coarse_count(), x.detail_count()}),
                           Grid<T>({y.detail_count(), x.coarse_count()}),
                           Grid<T>({y.detail_count(), x.detail_count()})};
    analyse_rows(x, low, result.coarse, details.cd, options.threads);
    analyse_rows(x, high, details.dc, details.dd, options.threads);
    result.details.push_back(std::move(details));
  }
  return result;
}

template <class T>
Grid<T> reconstruct_grid(const GridDecomposition<T>& parts, Extent fine_extent,
                         const Scheme& scheme, const GridReverseOptions& options, int steps) {
  const int levels = static_cast<int>(parts.details.size());
  if (steps < 0 || steps > levels)
    throw InvalidField("there are " + std::to_string(levels) + " levels of details, not " +
                       std::to_string(steps));
  GridReverseOptions all = options;
  all.levels = levels;
  const GridPyramid pyramid(scheme.mask(), fine_extent, all);
  check_extent(parts.coarse.extent(), pyramid.extent(levels), "the coarse grid", levels - 1);
  Grid<T> coarse = parts.coarse;
  for (int step = levels - 1; step >= levels - steps; --step) {
    const GridDetails<T>& details = parts.details[static_cast<std::size_t>(step)];
    const Extent extent = pyramid.extent(step);
    const AxisReverse<T> y(scheme.mask(), extent.rows, options.boundaries.y, options.mode);
    const AxisReverse<T> x(scheme.mask(), extent.cols, options.boundaries.x, options.mode);
    check_extent(details.cd.extent(), {y.coarse_count(), x.detail_count()}, "block cd", step);
    check_extent(details.dc.extent(), {y.detail_count(), x.coarse_count()}, "block dc", step);
    check_extent(details.dd.extent(), {y.detail_count(), x.detail_count()}, "block dd", step);
    Grid<T> low({y.coarse_count(), extent.cols});
    Grid<T> high({y.detail_count(), extent.cols});
    synthesise_rows(x, coarse, details.cd, low, options.threads);
    synthesise_rows(x, details.dc, details.dd, high, options.threads);
    coarse = Grid<T>(extent);
    synthesise_columns(y, low, high, coarse, options.threads);
  }
  return coarse;
}

template GridDecomposition<float> decompose_grid(GridView<const float>, const Scheme&,
                                                 const GridReverseOptions&);
template GridDecomposition<double> decompose_grid(GridView<const double>, const Scheme&,
                                                  const GridReverseOptions&);
template Grid<float> reconstruct_grid(const GridDecomposition<float>&, Extent, const Scheme&,
                                      const GridReverseOptions&, int);
template Grid<double> reconstruct_grid(const GridDecomposition<double>&, Extent, const Scheme&,
                                       const GridReverseOptions&, int);

}  // namespace arete
