// SPDX-License-Identifier: MIT
#include "arete/variational/cardinal_source.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace arete {

template <class T>
CardinalSource<T>::CardinalSource(const RowSource<T>& source, const Stencil& limit_x,
                                  const Stencil& limit_y, const Boundaries& boundaries)
    : source_(source),
      x_(limit_x, boundaries.x, source.extent().cols),
      limit_y_(limit_y),
      boundary_y_(boundaries.y),
      halo_(cardinal_reach(limit_y)) {
  const Index rows = source.extent().rows;
  // Also says whether the whole axis can be solved at all.
  (void)CardinalAxis<double>(limit_y, boundaries.y, rows);
  if (2 * halo_ + block_rows >= rows) rows_in_block_ = rows;
}

template <class T>
double CardinalSource<T>::working_bytes() const {
  const Extent size = source_.extent();
  const double kept = static_cast<double>(std::min(rows_in_block_, size.rows)) * sizeof(T) *
                      static_cast<double>(keep_blocks);
  const double made = static_cast<double>(std::min(rows_in_block_ + 2 * halo_, size.rows)) * 8;
  return (kept + made) * static_cast<double>(size.cols);
}

template <class T>
void CardinalSource<T>::read(Index r, T* out) const {
  const auto holder = block(r / rows_in_block_);
  std::copy_n(holder->rows.row(r - holder->number * rows_in_block_),
              static_cast<std::size_t>(holder->rows.cols()), out);
}

template <class T>
std::shared_ptr<const typename CardinalSource<T>::Block> CardinalSource<T>::block(
    Index number) const {
  const std::lock_guard lock(mutex_);
  for (auto it = kept_.begin(); it != kept_.end(); ++it)
    if ((*it)->number == number) {
      kept_.splice(kept_.begin(), kept_, it);  // most recent first
      return kept_.front();
    }
  kept_.push_front(solved(number));
  if (kept_.size() > keep_blocks) kept_.pop_back();
  return kept_.front();
}

template <class T>
std::shared_ptr<const typename CardinalSource<T>::Block> CardinalSource<T>::solved(
    Index number) const {
  const Extent size = source_.extent();
  const Index first = number * rows_in_block_;
  const Index last = std::min(first + rows_in_block_, size.rows) - 1;
  const bool whole = rows_in_block_ == size.rows;
  const bool wraps = boundary_y_ == Boundary::periodic && !whole;
  const Index begin = whole ? 0 : wraps ? first - halo_ : std::max<Index>(0, first - halo_);
  const Index end = whole   ? size.rows - 1
                    : wraps ? last + halo_
                            : std::min(size.rows - 1, last + halo_);

  Grid<double> work({end - begin + 1, size.cols});
  std::vector<T> line(static_cast<std::size_t>(size.cols));
  for (Index r = begin; r <= end; ++r) {
    const Index from = ((r % size.rows) + size.rows) % size.rows;
    source_.read(from, line.data());
    for (Index c = 0; c < size.cols; ++c) {
      const T value = line[static_cast<std::size_t>(c)];
      if (!std::isfinite(value))
        throw InvalidField("the sample in row " + std::to_string(from) + ", column " +
                           std::to_string(c) +
                           " is missing, and the limit cannot be made to pass "
                           "through it; fill the holes, or refine without interpolation");
      work(r - begin, c) = static_cast<double>(value);
    }
    x_.solve(work.row(r - begin));
  }

  // At the raster's own ends its boundary holds, at a cut a mirror.
  const Boundary before = whole || (begin == 0 && !wraps) ? boundary_y_ : Boundary::reflect;
  const Boundary after =
      whole || (end == size.rows - 1 && !wraps) ? boundary_y_ : Boundary::reflect;
  const CardinalAxis<double> columns(limit_y_, before, after, work.rows());
  columns.solve_lines(work.row(0), work.cols(), work.cols());

  auto result = std::make_shared<Block>();
  result->number = number;
  result->rows = Grid<T>({last - first + 1, size.cols});
  for (Index r = first; r <= last; ++r)
    for (Index c = 0; c < size.cols; ++c)
      result->rows(r - first, c) = static_cast<T>(work(r - begin, c));
  return result;
}

template class CardinalSource<float>;
template class CardinalSource<double>;

}  // namespace arete
