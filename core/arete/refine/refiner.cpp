// SPDX-License-Identifier: MIT
#include "arete/refine/refiner.h"

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <limits>

namespace arete {
namespace {

// Tall enough that the halo recomputed at its start costs little, short enough to share out.
constexpr Index part_rows = 256;

AxisPlan make_plan(const Scheme& scheme, Index count, const RefineOptions& options,
                   Boundary boundary, const std::optional<Stencil>& final_stencil) {
  return {scheme.mask(), count,
          AxisOptions{options.levels, boundary, options.alignment, final_stencil,
                      options.final_result}};
}

// A pipe needs as many levels along x as along y; an axis that has fewer passes rows on.
template <class T>
std::vector<PhasedRule<T>> phased(const AxisPlan& plan) {
  std::vector<PhasedRule<T>> rules;
  for (const LevelRule& rule : plan.rules()) rules.emplace_back(rule);
  return rules;
}

// The cells [i, i+1] that hold a sample at position x: two where x is an integer.
struct Cells {
  Index first;
  Index last;
};

Cells cells_at(const Rational& position, Index count, Boundary boundary) {
  if (count == 1) return {0, 0};
  const Index whole = static_cast<Index>(floor(position));
  Cells cells{is_integer(position) ? whole - 1 : whole, whole};
  if (boundary == Boundary::periodic) return cells;
  const auto clamp = [&](Index i) { return std::clamp(i, Index{0}, count - 2); };
  return {clamp(cells.first), clamp(cells.last)};
}

}  // namespace

template <class T>
Refiner<T>::Refiner(const Scheme& x, const Scheme& y, Extent input, const RefineOptions& options)
    : Refiner(make_plan(x, input.cols, options, options.boundaries.x, options.final_x),
              make_plan(y, input.rows, options, options.boundaries.y, options.final_y),
              options.threads, options.detail) {}

template <class T>
Refiner<T>::Refiner(AxisPlan x, AxisPlan y, int threads, const std::optional<Detail>& detail)
    : x_(std::move(x)), y_(std::move(y)), threads_(threads) {
  // Pass rows on unchanged along the axis that has fewer levels, before its first one.
  x_.pad_levels(y_.rules().size());
  y_.pad_levels(x_.rules().size());
  x_rules_ = phased<T>(x_);
  y_rules_ = phased<T>(y_);
  reach_ = std::max(x_.reach(), y_.reach());
  if (!detail) return;
  // Made in any case, because it checks its numbers.
  auto displacement = std::make_shared<const Displacement<T>>(*detail, x_, y_);
  if (detail->relief > 0) displacement_ = std::move(displacement);
}

template <class T>
double Refiner<T>::working_bytes(Index band_rows) const {
  const Index rows = std::clamp(band_rows, Index{1}, std::min(part_rows, y_.output_count()));
  const std::vector<IndexRange> needed = y_.ranges_for({0, rows - 1});
  double samples = static_cast<double>(needed.front().count() + 4 * reach_ + 6) *
                   static_cast<double>(x_.input_count());
  if (displacement_) samples *= 2;  // the relief of as many rows
  for (std::size_t level = 0; level < y_rules_.size(); ++level)
    samples += static_cast<double>(x_.ranges()[level].count()) *
               static_cast<double>(y_.rules()[level].symbol.coefficients().size() + 1);
  samples += 3.0 * static_cast<double>(x_.output_count());
  const int threads = threads_ > 0 ? threads_ : available_threads();
  return samples * sizeof(T) * threads;
}

template <class T>
void Refiner<T>::refine_rows(const RowSource<T>& source, Index first_row, GridView<T> band) const {
  if (source.extent() != input())
    throw InvalidField("the source has another size than the refiner was prepared for");
  if (band.cols() != x_.output_count() || first_row < 0 ||
      first_row + band.rows() > y_.output_count())
    throw InvalidField("the band does not lie within the result");
  const auto part = [&](Index from, Index to) {
    refine_part(source, first_row + from,
                GridView<T>(band.row(from), {to - from, band.cols()}, band.stride()));
  };
  if (threads_ == 1) {
    for (Index from = 0; from < band.rows(); from += part_rows)
      part(from, std::min(from + part_rows, band.rows()));
    return;
  }
  // More threads than the machine has would only make oneTBB complain.
  const int available = available_threads();
  const int wanted = threads_ > 0 ? threads_ : available;
  tbb::task_arena arena(std::min(wanted, available));
  const Index share = std::clamp(band.rows() / (2 * wanted), Index{32}, part_rows);
  const Index parts = (band.rows() + share - 1) / share;
  arena.execute([&] {
    tbb::parallel_for(Index{0}, parts,
                      [&](Index i) { part(i * share, std::min((i + 1) * share, band.rows())); });
  });
}

template <class T>
void Refiner<T>::refine_part(const RowSource<T>& source, Index first_row, GridView<T> part) const {
  if (part.rows() == 0) return;
  const IndexRange outputs{first_row, first_row + part.rows() - 1};
  IndexRange needed = y_.ranges_for(outputs).front();
  IndexRange relief_rows;
  if (displacement_) {
    relief_rows = displacement_->relief_rows(outputs);
    // The relief of a row looks at its neighbours.
    needed.first = std::min(needed.first, relief_rows.first - 1);
    needed.last = std::max(needed.last, relief_rows.last + 1);
  }
  const InputWindow<T> input(source, needed, boundaries(), reach_);
  std::optional<LocalRelief<T>> relief;
  if (displacement_) relief.emplace(input, boundaries(), relief_rows);
  RowPipe<T> pipe(y_rules_, y_, x_rules_, x_, input, outputs,
                  {displacement_.get(), relief ? &*relief : nullptr});
  for (Index r = 0; r < part.rows(); ++r) pipe.next(part.row(r));
  if (!input.complete()) clear_missing(input, first_row, part);
}

template <class T>
void Refiner<T>::clear_missing(const InputWindow<T>& input, Index first_row,
                               GridView<T> part) const {
  const Extent extent = this->input();
  std::vector<Cells> column_cells;
  column_cells.reserve(static_cast<std::size_t>(part.cols()));
  Rational position = x_.first_position();
  for (Index c = 0; c < part.cols(); ++c, position += x_.spacing())
    column_cells.push_back(cells_at(position, extent.cols, x_.boundary()));
  const Index lowest = std::min(column_cells.front().first, column_cells.back().first);
  const Index highest = std::max(column_cells.front().last, column_cells.back().last);

  std::vector<bool> valid_cells(static_cast<std::size_t>(highest - lowest + 1));
  Cells previous{1, 0};
  for (Index r = 0; r < part.rows(); ++r) {
    const Cells rows =
        cells_at(y_.first_position() + (first_row + r) * y_.spacing(), extent.rows, y_.boundary());
    if (rows.first != previous.first || rows.last != previous.last) {
      const auto valid_cell = [&](Index i, Index j) {
        const Index below = extent.rows == 1 ? i : i + 1;
        const Index right = extent.cols == 1 ? j : j + 1;
        return input.valid(i, j) && input.valid(i, right) && input.valid(below, j) &&
               input.valid(below, right);
      };
      for (Index j = lowest; j <= highest; ++j)
        valid_cells[static_cast<std::size_t>(j - lowest)] =
            valid_cell(rows.first, j) || valid_cell(rows.last, j);
      previous = rows;
    }
    for (Index c = 0; c < part.cols(); ++c) {
      const Cells cells = column_cells[static_cast<std::size_t>(c)];
      if (!valid_cells[static_cast<std::size_t>(cells.first - lowest)] &&
          !valid_cells[static_cast<std::size_t>(cells.last - lowest)])
        part(r, c) = std::numeric_limits<T>::quiet_NaN();
    }
  }
}

template <class T>
Grid<T> Refiner<T>::operator()(GridView<const T> samples) const {
  Grid<T> result(output());
  refine_rows(GridSource<T>(samples), 0, result.view());
  return result;
}

int available_threads() { return tbb::info::default_concurrency(); }

template <class T>
Grid<T> refine(GridView<const T> samples, const Scheme& scheme, const RefineOptions& options) {
  return Refiner<T>(scheme, samples.extent(), options)(samples);
}

template class Refiner<float>;
template class Refiner<double>;
template Grid<float> refine(GridView<const float>, const Scheme&, const RefineOptions&);
template Grid<double> refine(GridView<const double>, const Scheme&, const RefineOptions&);

}  // namespace arete
