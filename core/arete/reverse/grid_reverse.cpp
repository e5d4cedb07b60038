// SPDX-License-Identifier: MIT
#include "arete/reverse/grid_reverse.h"

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace arete {
namespace {

// Lanes worked on at a time: enough to fill vector registers, few enough to stay in cache.
constexpr Index lanes_at_a_time = 64;

// Calls work(first, count) for runs of lanes that cover 0..lanes-1.
template <class Work>
void for_runs(Index lanes, int threads, Work&& work) {
  const Index runs = ceil_divide(lanes, lanes_at_a_time);
  const auto run = [&](Index i) {
    const Index first = i * lanes_at_a_time;
    work(first, std::min(lanes_at_a_time, lanes - first));
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
Lines<const T> columns_of(const Grid<T>& grid, Index first, Index count) {
  return {grid.samples().data() + first, grid.rows(), count, grid.cols()};
}

// Rows first.. of the grid, turned so that samples of a row follow each other line by line.
template <class T>
void turn_in(const Grid<T>& grid, Index first, Lines<T> lines) {
  for (Index lane = 0; lane < lines.lanes; ++lane) {
    const T* row = grid.row(first + lane);
    for (Index c = 0; c < lines.count; ++c) lines[c][lane] = row[c];
  }
}
template <class T>
void turn_out(Lines<const T> lines, Grid<T>& grid, Index first) {
  for (Index lane = 0; lane < lines.lanes; ++lane) {
    T* row = grid.row(first + lane);
    for (Index c = 0; c < lines.count; ++c) row[c] = lines[c][lane];
  }
}

template <class T>
void analyse_columns(const AxisReverse<T>& axis, const Grid<T>& fine, Grid<T>& coarse,
                     Grid<T>& details, int threads) {
  for_runs(fine.cols(), threads, [&](Index first, Index count) {
    axis.analyse(columns_of(fine, first, count), columns_of(coarse, first, count),
                 columns_of(details, first, count));
  });
}

template <class T>
void synthesise_columns(const AxisReverse<T>& axis, const Grid<T>& coarse, const Grid<T>& details,
                        Grid<T>& fine, int threads) {
  for_runs(fine.cols(), threads, [&](Index first, Index count) {
    axis.synthesise(columns_of(coarse, first, count), columns_of(details, first, count),
                    columns_of(fine, first, count));
  });
}

template <class T>
void analyse_rows(const AxisReverse<T>& axis, const Grid<T>& fine, Grid<T>& coarse,
                  Grid<T>& details, int threads) {
  for_runs(fine.rows(), threads, [&](Index first, Index count) {
    LineBuffer<T> in(fine.cols(), count);
    LineBuffer<T> low(coarse.cols(), count);
    LineBuffer<T> high(details.cols(), count);
    turn_in(fine, first, in.lines());
    axis.analyse(in.lines(), low.lines(), high.lines());
    turn_out<T>(low.lines(), coarse, first);
    turn_out<T>(high.lines(), details, first);
  });
}

template <class T>
void synthesise_rows(const AxisReverse<T>& axis, const Grid<T>& coarse, const Grid<T>& details,
                     Grid<T>& fine, int threads) {
  for_runs(fine.rows(), threads, [&](Index first, Index count) {
    LineBuffer<T> low(coarse.cols(), count);
    LineBuffer<T> high(details.cols(), count);
    LineBuffer<T> out(fine.cols(), count);
    turn_in(coarse, first, low.lines());
    turn_in(details, first, high.lines());
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
  GridDecomposition<T> result{Grid<T>(samples.extent()), {}};
  for (Index r = 0; r < samples.rows(); ++r)
    std::copy_n(samples.row(r), samples.cols(), result.coarse.row(r));
  for (int step = 0; step < options.levels; ++step) {
    const Grid<T> fine = std::move(result.coarse);
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
