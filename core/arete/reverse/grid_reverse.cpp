// SPDX-License-Identifier: MIT
#include "arete/reverse/grid_reverse.h"

#include "arete/reverse/grid_reverse_lines.h"
#include "arete/reverse/grid_reverse_local.h"

namespace arete {
namespace {

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

namespace {

template <class T>
Grid<T> copy_of(GridView<const T> samples) {
  Grid<T> copy(samples.extent());
  for (Index r = 0; r < samples.rows(); ++r)
    std::copy_n(samples.row(r), samples.cols(), copy.row(r));
  return copy;
}

template <class T>
std::vector<GridStepAxes<T>> axes_of(const GridPyramid& pyramid, const Mask& mask,
                                     const GridReverseOptions& options, int first) {
  std::vector<GridStepAxes<T>> steps;
  for (int step = first; step < pyramid.levels(); ++step) {
    const Extent extent = pyramid.extent(step);
    steps.push_back({AxisReverse<T>(mask, extent.rows, options.boundaries.y, options.mode),
                     AxisReverse<T>(mask, extent.cols, options.boundaries.x, options.mode)});
  }
  return steps;
}

template <class T>
GridDetails<T> details_for(const GridStepAxes<T>& axes) {
  return {Grid<T>({axes.y.coarse_count(), axes.x.detail_count()}),
          Grid<T>({axes.y.detail_count(), axes.x.coarse_count()}),
          Grid<T>({axes.y.detail_count(), axes.x.detail_count()})};
}

}  // namespace

template <class T>
GridDecomposition<T> decompose_grid(GridView<const T> samples, const Scheme& scheme,
                                    const GridReverseOptions& options) {
  const GridPyramid pyramid(scheme.mask(), samples.extent(), options);
  const auto steps = axes_of<T>(pyramid, scheme.mask(), options, 0);
  GridDecomposition<T> result;
  if (steps.empty()) {
    result.coarse = copy_of(samples);
    return result;
  }
  for (const auto& axes : steps) result.details.push_back(details_for(axes));
  if (all_local(steps)) {
    result.coarse = Grid<T>(pyramid.extent(options.levels));
    decompose_by_rows(steps, samples, result.coarse, result.details, options.threads);
    return result;
  }
  Grid<T> before;
  for (std::size_t step = 0; step < steps.size(); ++step) {
    const GridView<const T> fine = step == 0 ? samples : std::as_const(before).view();
    Grid<T> coarse({steps[step].y.coarse_count(), steps[step].x.coarse_count()});
    analyse_step(steps[step], fine, coarse, result.details[step], options.threads);
    before = std::move(coarse);
  }
  result.coarse = std::move(before);
  return result;
}

template <class T>
Grid<T> reconstruct_grid(const GridDecomposition<T>& parts, Extent fine_extent,
                         const Scheme& scheme, const GridReverseOptions& options, int count) {
  const int levels = static_cast<int>(parts.details.size());
  if (count < 0 || count > levels)
    throw InvalidField("there are " + std::to_string(levels) + " levels of details, not " +
                       std::to_string(count));
  GridReverseOptions all = options;
  all.levels = levels;
  const GridPyramid pyramid(scheme.mask(), fine_extent, all);
  check_extent(parts.coarse.extent(), pyramid.extent(levels), "the coarse grid", levels - 1);
  const int first = levels - count;
  const auto steps = axes_of<T>(pyramid, scheme.mask(), options, first);
  const auto details = std::span(parts.details).subspan(static_cast<std::size_t>(first));
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const auto& [y, x] = steps[k];
    const int step = first + static_cast<int>(k);
    check_extent(details[k].cd.extent(), {y.coarse_count(), x.detail_count()}, "block cd", step);
    check_extent(details[k].dc.extent(), {y.detail_count(), x.coarse_count()}, "block dc", step);
    check_extent(details[k].dd.extent(), {y.detail_count(), x.detail_count()}, "block dd", step);
  }
  if (count == 0) return parts.coarse;
  if (all_local(steps)) {
    Grid<T> result(pyramid.extent(first));
    reconstruct_by_rows<T>(steps, parts.coarse, details, result, options.threads);
    return result;
  }
  Grid<T> samples;
  for (std::size_t k = steps.size(); k-- > 0;)
    samples = synthesise_step(steps[k], k + 1 == steps.size() ? parts.coarse : samples, details[k],
                              options.threads);
  return samples;
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
