// SPDX-License-Identifier: MIT
#include "arete/reverse/missing_samples.h"

#include <algorithm>
#include <cmath>

namespace arete {
namespace {

template <class Visit>
void for_neighbours(Extent extent, Index place, Visit&& visit) {
  const Index r = place / extent.cols;
  const Index c = place % extent.cols;
  for (Index i = std::max<Index>(0, r - 1); i <= std::min(extent.rows - 1, r + 1); ++i)
    for (Index j = std::max<Index>(0, c - 1); j <= std::min(extent.cols - 1, c + 1); ++j)
      if (i != r || j != c) visit(i, j);
}

// The fine samples nearest to each coarse one along an axis.
std::vector<IndexRange> nearest(const ReverseLevel& axis) {
  std::vector<IndexRange> ranges;
  // The integers nearest to coarse sample 0: one, or two when it lies midway.
  const Rational shift = axis.fine_count == 1 ? Rational(0) : Rational(axis.tau - axis.rows.first);
  const Rational half(1, 2);
  const auto lowest = static_cast<Index>(ceil(Rational(shift - half)));
  const auto highest = static_cast<Index>(floor(Rational(shift + half)));
  const Index spacing = axis.fine_count == 1 ? 0 : axis.arity;
  for (Index j = 0; j < axis.coarse_count; ++j) {
    IndexRange range{lowest + spacing * j, highest + spacing * j};
    if (axis.closed) {
      ranges.push_back(range);
      continue;
    }
    range.first = std::clamp<Index>(range.first, 0, axis.fine_count - 1);
    range.last = std::clamp<Index>(range.last, 0, axis.fine_count - 1);
    ranges.push_back(range);
  }
  return ranges;
}

}  // namespace

template <class T>
ValidSamples fill_missing(GridView<T> samples) {
  const Extent extent = samples.extent();
  ValidSamples valid(static_cast<std::size_t>(extent.rows * extent.cols), 1);
  std::vector<Index> rim;
  Index missing = 0;
  for (Index r = 0; r < extent.rows; ++r)
    for (Index c = 0; c < extent.cols; ++c)
      if (!std::isfinite(samples(r, c))) {
        valid[static_cast<std::size_t>(r * extent.cols + c)] = 0;
        ++missing;
      }
  if (missing == 0) return {};
  if (missing == extent.rows * extent.cols)
    throw InvalidField("no sample of the grid is valid; check its nodata value");

  // Rounds: 1 known, 0 unknown, 2 in the rim of this round.
  ValidSamples known = valid;
  const auto state = [&](Index r, Index c) -> std::uint8_t& {
    return known[static_cast<std::size_t>(r * extent.cols + c)];
  };
  for (Index place = 0; place < extent.rows * extent.cols; ++place) {
    if (known[static_cast<std::size_t>(place)] != 0) continue;
    bool beside = false;
    for_neighbours(extent, place, [&](Index i, Index j) { beside = beside || state(i, j) == 1; });
    if (beside) rim.push_back(place);
  }
  while (!rim.empty()) {
    for (const Index place : rim) {
      T sum = 0;
      int count = 0;
      for_neighbours(extent, place, [&](Index i, Index j) {
        if (state(i, j) != 1) return;
        sum += samples(i, j);
        ++count;
      });
      samples(place / extent.cols, place % extent.cols) = sum / static_cast<T>(count);
    }
    for (const Index place : rim) known[static_cast<std::size_t>(place)] = 1;
    std::vector<Index> next;
    for (const Index place : rim)
      for_neighbours(extent, place, [&](Index i, Index j) {
        if (state(i, j) != 0) return;
        state(i, j) = 2;
        next.push_back(i * extent.cols + j);
      });
    rim = std::move(next);
  }
  return valid;
}

ValidSamples coarsened(const ValidSamples& fine, const ReverseLevel& rows,
                       const ReverseLevel& cols) {
  if (fine.empty()) return {};
  const std::vector<IndexRange> row_ranges = nearest(rows);
  const std::vector<IndexRange> col_ranges = nearest(cols);
  ValidSamples coarse;
  for (const IndexRange& r : row_ranges)
    for (const IndexRange& c : col_ranges) {
      bool all = true;
      for (Index i = r.first; i <= r.last; ++i)
        for (Index j = c.first; j <= c.last; ++j) {
          const Index row = ((i % rows.fine_count) + rows.fine_count) % rows.fine_count;
          const Index col = ((j % cols.fine_count) + cols.fine_count) % cols.fine_count;
          all = all && fine[static_cast<std::size_t>(row * cols.fine_count + col)] != 0;
        }
      coarse.push_back(all ? 1 : 0);
    }
  return coarse;
}

ValidSamples coarsened(ValidSamples fine, const GridPyramid& pyramid, int steps) {
  for (int step = 0; step < steps; ++step)
    fine = coarsened(fine, pyramid.rows(step), pyramid.cols(step));
  return fine;
}

template ValidSamples fill_missing(GridView<float>);
template ValidSamples fill_missing(GridView<double>);

}  // namespace arete
