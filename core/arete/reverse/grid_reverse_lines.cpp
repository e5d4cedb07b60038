// SPDX-License-Identifier: MIT
#include "arete/reverse/grid_reverse_lines.h"

#include "arete/parallel/for_each_band.h"

namespace arete {
namespace {

// Lanes worked on at a time: enough to fill vector registers, few enough to stay in cache.
constexpr Index rows_at_a_time = 32;
constexpr Index columns_at_a_time = 256;

// Columns first.. of a grid as lines down its rows, in place.
template <class T>
Lines<T> columns_of(GridView<T> grid, Index first, Index count) {
  return {grid.row(0) + first, grid.rows(), count, grid.stride()};
}

template <class T>
void copy_lines(Lines<const T> from, Lines<T> to) {
  for (Index i = 0; i < from.count; ++i) std::copy_n(from[i], from.lanes, to[i]);
}

// Rows first.. of a grid, turned so that samples of a row follow each other line by line. A few
// columns at a time, so that what is written lies together.
constexpr Index turned_at_a_time = 16;
// Rows are too many streams for the processor to see them coming.
constexpr Index turned_ahead = 64;

template <class T>
void turn_in(const Grid<T>& grid, Index first, Lines<T> lines) {
  for (Index from = 0; from < lines.count; from += turned_at_a_time) {
    const Index to = std::min(from + turned_at_a_time, lines.count);
    for (Index lane = 0; lane < lines.lanes; ++lane) {
      const T* row = grid.row(first + lane);
      if (from + turned_ahead < lines.count) __builtin_prefetch(row + from + turned_ahead, 0);
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
      if (from + turned_ahead < lines.count) __builtin_prefetch(row + from + turned_ahead, 1);
      for (Index c = from; c < to; ++c) row[c] = lines[c][lane];
    }
  }
}

// Down the columns of `fine` from column `first` on, as many as `low` and `high` hold of them.
template <class T>
void analyse_columns(const AxisReverse<T>& axis, GridView<const T> fine, Index first, Grid<T>& low,
                     Grid<T>& high, int threads) {
  for_each_band(std::min(low.cols(), fine.cols() - first), columns_at_a_time, threads,
           [&](Index from, Index count) {
             axis.analyse(columns_of(fine, first + from, count),
                          columns_of(low.view(), from, count),
                          columns_of(high.view(), from, count));
           });
}

// Along the rows that `low` and `high` hold side by side, in place.
template <class T>
void analyse_rows(const AxisReverse<T>& axis, Grid<T>& low, Grid<T>& high, int threads) {
  for_each_band(low.rows(), rows_at_a_time, threads, [&](Index first, Index count) {
    LineBuffer<T> fine(axis.fine_count(), count);
    LineBuffer<T> halves(low.cols() + high.cols(), count);
    const Lines<T> coarse = halves.lines().part(0, low.cols());
    const Lines<T> details = halves.lines().part(low.cols(), high.cols());
    turn_in(low, first, fine.lines().part(0, low.cols()));
    turn_in(high, first, fine.lines().part(low.cols(), axis.fine_count() - low.cols()));
    axis.analyse(fine.lines(), coarse, details);
    turn_out<T>(coarse, low, first);
    turn_out<T>(details, high, first);
  });
}

// Rows `first`.. of `fine` from their halves.
template <class T>
void synthesise_rows(const AxisReverse<T>& axis, const Grid<T>& low, const Grid<T>& high,
                     Grid<T>& fine, Index first, int threads) {
  for_each_band(low.rows(), rows_at_a_time, threads, [&](Index from, Index count) {
    LineBuffer<T> coarse(low.cols(), count);
    LineBuffer<T> details(high.cols(), count);
    LineBuffer<T> out(axis.fine_count(), count);
    turn_in(low, from, coarse.lines());
    turn_in(high, from, details.lines());
    axis.synthesise(coarse.lines(), details.lines(), out.lines());
    turn_out<T>(out.lines(), fine, first + from);
  });
}

// Down the columns, in place: the first rows are coarse samples, the others details.
template <class T>
void synthesise_columns(const AxisReverse<T>& axis, Grid<T>& samples, int threads) {
  for_each_band(samples.cols(), columns_at_a_time, threads, [&](Index first, Index count) {
    LineBuffer<T> halves(samples.rows(), count);
    const Lines<T> columns = columns_of(samples.view(), first, count);
    copy_lines<T>(columns, halves.lines());
    axis.synthesise(halves.lines().part(0, axis.coarse_count()),
                    halves.lines().part(axis.coarse_count(), axis.detail_count()),
                    columns.part(0, axis.fine_count()));
  });
}

}  // namespace

// In between, coarse and cd side by side hold the
// coarse rows, dc and dd the rows of details, so that nothing else of that size is needed.
template <class T>
void analyse_step(const GridStepAxes<T>& axes, GridView<const T> fine, Grid<T>& coarse,
                  GridDetails<T>& details, int threads) {
  analyse_columns(axes.y, fine, 0, coarse, details.dc, threads);
  analyse_columns(axes.y, fine, coarse.cols(), details.cd, details.dd, threads);
  analyse_rows(axes.x, coarse, details.cd, threads);
  analyse_rows(axes.x, details.dc, details.dd, threads);
}

template <class T>
Grid<T> synthesise_step(const GridStepAxes<T>& axes, const Grid<T>& coarse,
                        const GridDetails<T>& details, int threads) {
  Grid<T> samples({coarse.rows() + details.dc.rows(), axes.x.fine_count()});
  synthesise_rows(axes.x, coarse, details.cd, samples, 0, threads);
  synthesise_rows(axes.x, details.dc, details.dd, samples, coarse.rows(), threads);
  synthesise_columns(axes.y, samples, threads);
  // A closed axis may have had samples appended.
  if (samples.rows() == axes.y.fine_count()) return samples;
  Grid<T> cut({axes.y.fine_count(), samples.cols()});
  std::copy_n(samples.samples().begin(), cut.samples().size(), cut.samples().begin());
  return cut;
}

template void analyse_step(const GridStepAxes<float>&, GridView<const float>, Grid<float>&,
                           GridDetails<float>&, int);
template void analyse_step(const GridStepAxes<double>&, GridView<const double>, Grid<double>&,
                           GridDetails<double>&, int);
template Grid<float> synthesise_step(const GridStepAxes<float>&, const Grid<float>&,
                                     const GridDetails<float>&, int);
template Grid<double> synthesise_step(const GridStepAxes<double>&, const Grid<double>&,
                                      const GridDetails<double>&, int);

}  // namespace arete
