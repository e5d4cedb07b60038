// SPDX-License-Identifier: MIT
#include "arete/refine/refiner.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "arete/parallel/for_each_band.h"

namespace arete {
namespace {

// Results larger than this are written past the cache: they would push out what is still needed,
// and each line would be read from memory before it is overwritten.
constexpr double cache_bytes = 4e6;

// The rows that a strip of the last level is made of stay in the second cache; narrower strips
// spend more on the beginnings of rows than the first cache gives back.
constexpr Index strip_columns = 4096;
constexpr Index widest_strip = 6144;

// A part is tall enough that the halo recomputed at its start costs little, but its input is small.
constexpr Index least_part_rows = 256;
constexpr Index most_part_rows = 8192;
constexpr double part_input_bytes = 4e6;

AxisPlan make_plan(const Scheme& scheme, Index count, const RefineOptions& options,
                   Boundary boundary, const std::optional<Stencil>& final_stencil) {
  return {scheme.mask(), count,
          AxisOptions{options.levels, boundary, options.alignment, final_stencil,
                      options.final_result}};
}

template <class T>
std::vector<PhasedRule<T>> phased(const AxisPlan& plan) {
  std::vector<PhasedRule<T>> rules;
  for (const LevelRule& rule : plan.rules()) rules.emplace_back(rule);
  return rules;
}

// A pipe needs as many levels along x as along y; an axis that has fewer passes rows on unchanged
// before its first one.
AxisPlan padded(AxisPlan plan, const AxisPlan& other) {
  plan.pad_levels(other.rules().size());
  return plan;
}

std::vector<IndexRange> strips_of(Index columns, Index arity) {
  if (columns <= widest_strip) return {{0, columns - 1}};
  const Index count = (columns + strip_columns / 2) / strip_columns;
  // Strips begin on cache lines where rows do, and with the first phase of the last level.
  const Index whole = std::lcm(Index{16}, arity);
  const Index width = ((columns + count - 1) / count + whole - 1) / whole * whole;
  std::vector<IndexRange> strips;
  for (Index first = 0; first < columns; first += width)
    strips.push_back({first, std::min(first + width, columns) - 1});
  return strips;
}

}  // namespace

template <class T>
Refiner<T>::Refiner(const Scheme& x, const Scheme& y, Extent input, const RefineOptions& options)
    : Refiner(make_plan(x, input.cols, options, options.boundaries.x, options.final_x),
              make_plan(y, input.rows, options, options.boundaries.y, options.final_y),
              options.threads, options.detail) {}

template <class T>
Refiner<T>::Refiner(AxisPlan x, AxisPlan y, int threads, const std::optional<Detail>& detail)
    : x_(padded(std::move(x), y)),
      y_(padded(std::move(y), x_)),
      threads_(threads),
      reach_(std::max(x_.reach(), y_.reach())),
      rules_{phased<T>(x_), phased<T>(y_)},
      x_cells_(x_),
      y_cells_(y_),
      strips_(strips_of(x_.output_count(), rules_.x.empty() ? 1 : rules_.x.back().arity)) {
  if (!detail) return;
  // Made in any case, because it checks its numbers.
  auto displacement = std::make_shared<const Displacement<T>>(*detail, x_, y_);
  if (detail->relief > 0) displacement_ = std::move(displacement);
}

template <class T>
Index Refiner<T>::rows_a_part() const {
  const double input_row = static_cast<double>(x_.input_count()) * sizeof(T);
  const double rows = part_input_bytes / input_row / to_double(y_.spacing());
  return static_cast<Index>(
      std::clamp(rows, static_cast<double>(least_part_rows), static_cast<double>(most_part_rows)));
}

template <class T>
double Refiner<T>::working_bytes(Index band_rows) const {
  const Index rows = std::clamp(band_rows, Index{1}, std::min(rows_a_part(), y_.output_count()));
  const std::vector<IndexRange> needed = y_.ranges_for({0, rows - 1});
  double samples = static_cast<double>(needed.front().count() + 4 * reach_ + 6) *
                   static_cast<double>(x_.input_count());
  if (displacement_) samples *= 2;  // the relief of as many rows
  const std::vector<IndexRange> columns = x_.ranges_for(strips_.front());
  for (std::size_t level = 0; level < rules_.y.size(); ++level)
    samples += static_cast<double>(columns[level].count() + 2 * kernel_slack) *
               static_cast<double>(y_.rules()[level].symbol.coefficients().size() + 2);
  samples += 4.0 * static_cast<double>(columns.back().count() + 2 * kernel_slack);
  const int threads = threads_ > 0 ? threads_ : available_threads();
  return samples * sizeof(T) * threads;
}

template <class T>
void Refiner<T>::check(const RowSource<T>& source, IndexRange rows) const {
  if (source.extent() != input())
    throw InvalidField("the source has another size than the refiner was prepared for");
  if (rows.first < 0 || rows.last >= y_.output_count())
    throw InvalidField("the band does not lie within the result");
}

template <class T>
void Refiner<T>::refine_rows(const RowSource<T>& source, Index first_row, GridView<T> band) const {
  check(source, {first_row, first_row + band.rows() - 1});
  if (band.cols() != x_.output_count())
    throw InvalidField("the band has another width than the result");
  const double bytes = static_cast<double>(band.rows()) * static_cast<double>(band.cols()) *
                       static_cast<double>(sizeof(T));
  const bool stream = bytes > cache_bytes;
  const Index most = rows_a_part();
  const int threads = threads_ > 0 ? threads_ : available_threads();
  const Index share =
      threads == 1 ? most : std::clamp(band.rows() / (4 * threads), Index{64}, most);
  tbb::enumerable_thread_specific<Workspace<T>> workspaces;
  for_each_band(band.rows(), share, threads_, [&](Index from, Index count) {
    refine_part(source, first_row + from, {band.row(from), {count, band.cols()}, band.stride()},
                stream, workspaces.local());
  });
}

template <class T>
typename Refiner<T>::Part Refiner<T>::open_part(const RowSource<T>& source, IndexRange rows) const {
  IndexRange needed = y_.ranges_for(rows).front();
  // Whether a result is valid is asked of the samples around it, which a final stencil that reads
  // from afar does not need.
  const bool turns = y_.boundary() == Boundary::periodic;
  const Index below = y_cells_.at(rows.last).last + 1;
  needed.first = std::min(needed.first, y_cells_.at(rows.first).first);
  needed.last = std::max(needed.last, turns ? below : std::min(below, input().rows - 1));
  if (!displacement_) return {rows, {source, needed, boundaries(), reach_}, {}};
  const IndexRange relief_rows = displacement_->relief_rows(rows);
  // The relief of a row looks at its neighbours.
  needed.first = std::min(needed.first, relief_rows.first - 1);
  needed.last = std::max(needed.last, relief_rows.last + 1);
  Part part{rows, {source, needed, boundaries(), reach_}, {}};
  part.relief.emplace(part.input, boundaries(), relief_rows);
  return part;
}

template <class T>
RowPipe<T> Refiner<T>::open_pipe(const Part& part, IndexRange columns,
                                 Workspace<T>& workspace) const {
  return RowPipe<T>(rules_, y_, x_, part.input, part.rows, columns, workspace,
                    {displacement_.get(), part.relief ? &*part.relief : nullptr});
}

template <class T>
void Refiner<T>::refine_part(const RowSource<T>& source, Index first_row, GridView<T> rows,
                             bool stream, Workspace<T>& workspace) const {
  if (rows.rows() == 0) return;
  const Part part = open_part(source, {first_row, first_row + rows.rows() - 1});
  for (const IndexRange& strip : strips_) {
    RowPipe<T> pipe = open_pipe(part, strip, workspace);
    for (Index r = 0; r < rows.rows(); ++r)
      pipe.next(rows.row(r) + strip.first, stream,
                r + 1 < rows.rows() ? rows.row(r + 1) + strip.first : nullptr);
    if (!part.input.complete())
      clear_missing(
          part.input, first_row, strip.first,
          GridView<T>(rows.row(0) + strip.first, {rows.rows(), strip.count()}, rows.stride()));
  }
  if (stream) kernels<T>().fence();
}

template <class T>
void Refiner<T>::for_each_tile(const RowSource<T>& source, IndexRange rows,
                               const TakeTile<T>& take) const {
  check(source, rows);
  // A tile stays in the first cache.
  constexpr double tile_bytes = 32e3;
  const Index stride = Workspace<T>::stride(strips_.front().count(), 0);
  const auto height =
      std::clamp(static_cast<Index>(tile_bytes / static_cast<double>(stride) / sizeof(T)), Index{1},
                 Index{64});
  Workspace<T> tile_memory;
  tile_memory.restart(height * stride);
  T* const tile = tile_memory.take(height * stride);
  Workspace<T> workspace;
  const Index most = rows_a_part();
  for (Index first = rows.first; first <= rows.last; first += most) {
    const Part part = open_part(source, {first, std::min(first + most - 1, rows.last)});
    for (const IndexRange& strip : strips_) {
      RowPipe<T> pipe = open_pipe(part, strip, workspace);
      for (Index row = first; row <= part.rows.last; row += height) {
        const GridView<T> view(tile, {std::min(height, part.rows.last - row + 1), strip.count()},
                               stride);
        for (Index r = 0; r < view.rows(); ++r) pipe.next(view.row(r));
        if (!part.input.complete()) clear_missing(part.input, row, strip.first, view);
        take(row, strip.first, view);
      }
    }
  }
}

template <class T>
void Refiner<T>::clear_missing(const InputWindow<T>& input, Index first_row, Index first_col,
                               GridView<T> tile) const {
  const Extent extent = this->input();
  std::vector<IndexRange> column_cells;
  column_cells.reserve(static_cast<std::size_t>(tile.cols()));
  for (Index c = 0; c < tile.cols(); ++c) column_cells.push_back(x_cells_.at(first_col + c));
  const Index lowest = std::min(column_cells.front().first, column_cells.back().first);
  const Index highest = std::max(column_cells.front().last, column_cells.back().last);

  std::vector<std::uint8_t> valid_cells(static_cast<std::size_t>(highest - lowest + 1));
  bool all_valid = false;
  IndexRange previous{1, 0};
  for (Index r = 0; r < tile.rows(); ++r) {
    const IndexRange rows = y_cells_.at(first_row + r);
    if (rows != previous) {
      const auto valid_cell = [&](Index i, Index j) {
        const Index below = extent.rows == 1 ? i : i + 1;
        const Index right = extent.cols == 1 ? j : j + 1;
        return input.valid(i, j) && input.valid(i, right) && input.valid(below, j) &&
               input.valid(below, right);
      };
      all_valid = true;
      for (Index j = lowest; j <= highest; ++j) {
        const bool valid = valid_cell(rows.first, j) || valid_cell(rows.last, j);
        valid_cells[static_cast<std::size_t>(j - lowest)] = valid ? 1 : 0;
        all_valid = all_valid && valid;
      }
      previous = rows;
    }
    if (all_valid) continue;
    for (Index c = 0; c < tile.cols(); ++c) {
      const IndexRange cells = column_cells[static_cast<std::size_t>(c)];
      if (valid_cells[static_cast<std::size_t>(cells.first - lowest)] == 0 &&
          valid_cells[static_cast<std::size_t>(cells.last - lowest)] == 0)
        tile(r, c) = std::numeric_limits<T>::quiet_NaN();
    }
  }
}

template <class T>
Grid<T> Refiner<T>::operator()(GridView<const T> samples) const {
  Grid<T> result(output());
  refine_rows(GridSource<T>(samples), 0, result.view());
  return result;
}

template <class T>
Plane<T> Refiner<T>::plane(GridView<const T> samples, Pages pages) const {
  Plane<T> result(output(), pages);
  refine_rows(GridSource<T>(samples), 0, result.view());
  return result;
}

template <class T>
Grid<T> refine(GridView<const T> samples, const Scheme& scheme, const RefineOptions& options) {
  return Refiner<T>(scheme, samples.extent(), options)(samples);
}

template class Refiner<float>;
template class Refiner<double>;
template Grid<float> refine(GridView<const float>, const Scheme&, const RefineOptions&);
template Grid<double> refine(GridView<const double>, const Scheme&, const RefineOptions&);

}  // namespace arete
