// SPDX-License-Identifier: MIT
#include "arete/refine/row_pipe.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace arete {
namespace {

// How many rows of the level before must be at hand at a time: from the lowest row that a phase
// yet to come reads to the highest that any phase has read.
template <class T>
Index rows_at_hand(const PhasedRule<T>& rule) {
  Index lowest = 0;
  Index highest = 0;
  for (const PhaseStencil<T>& phase : rule.phases) {
    lowest = std::min(lowest, phase.first);
    highest = std::max(highest, phase.first + static_cast<Index>(phase.weights.size()) - 1);
  }
  return highest - lowest + 1;
}

template <class T>
bool is_plain_one(const PhaseStencil<T>& stencil) {
  return stencil.weights.size() == 1 && stencil.weights[0] == T(1);
}

// The last level is made in runs of so many columns of the level before, this row's horizontal
// filter and the next row's vertical one in turn: the sums are long out of the store buffer when
// they are read, and the memory always has stores to work on.
constexpr Index run = 512;

// Samples in a cache line, and so in the longest vector.
template <class T>
constexpr Index line_samples = static_cast<Index>(Workspace<T>::alignment / sizeof(T));

template <class T>
Index full_vectors(Index count) {
  return (count + line_samples<T> - 1) / line_samples<T> * line_samples<T>;
}

// How many samples lie before the first cache line of a row.
template <class T>
Index before_line(const T* row) {
  const auto beyond = reinterpret_cast<std::uintptr_t>(row) % Workspace<T>::alignment;
  return static_cast<Index>((Workspace<T>::alignment - beyond) % Workspace<T>::alignment /
                            sizeof(T));
}

// Cache lines that a row fills in part are written as usual, and the streamed stores behind them
// wait until they have come from memory.
template <class T>
void fetch_edges(T* row, Index count) {
  if (before_line(row) > 0) __builtin_prefetch(row, 1);
  if (before_line(row + count) > 0) __builtin_prefetch(row + count - 1, 1);
}

// A row of a ring holds its columns, the last turn of those that make it, and slack.
template <class T>
Index ring_stride(Index columns, Index arity) {
  return full_vectors<T>(columns) + full_vectors<T>(arity * line_samples<T>) + kernel_slack;
}

}  // namespace

template <class T>
RowPipe<T>::RowPipe(const PipeRules<T>& rules, const AxisPlan& y, const AxisPlan& x,
                    const InputWindow<T>& input, IndexRange rows, IndexRange columns,
                    Workspace<T>& workspace, Hook detail)
    : rules_(rules),
      input_(input),
      kernels_(kernels<T>()),
      detail_(detail),
      depth_(rules.y.size()),
      rings_(depth_) {
  const std::vector<IndexRange> row_ranges = y.ranges_for(rows);
  const std::vector<IndexRange> column_ranges = x.ranges_for(columns);
  result_columns_ = column_ranges.back();
  next_result_ = row_ranges.back().first;
  last_result_ = row_ranges.back().last;
  Index total = 0;
  Index widest_sums = 0;
  std::size_t most_taps = 1;
  Index largest_arity = 1;
  for (std::size_t level = 0; level < depth_; ++level) {
    Ring& ring = rings_[level];
    ring.columns = column_ranges[level];
    ring.width = full_vectors<T>(ring.columns.count());
    // One row more, because the last level's vertical filter runs one row ahead.
    ring.height = static_cast<Index>(
        std::bit_ceil(static_cast<std::size_t>(rows_at_hand(rules.y[level]) + 1)));
    ring.stride = ring_stride<T>(ring.columns.count(), level > 0 ? rules.x[level - 1].arity : 1);
    ring.next_row = row_ranges[level].first;
    const Index arity = rules.x[level].arity;
    ring.strands = strands_at(level, column_ranges[level + 1].first);
    ring.turns = full_vectors<T>((column_ranges[level + 1].count() + arity - 1) / arity);
    total += ring.height * ring.stride;
    widest_sums = std::max(widest_sums, ring.stride);
    largest_arity = std::max(largest_arity, arity);
    for (const PhaseStencil<T>& phase : rules.y[level].phases)
      most_taps = std::max(most_taps, phase.weights.size());
  }
  const Index result_stride = Workspace<T>::stride(result_columns_.count(), kernel_slack);
  workspace.restart(total + 3 * widest_sums + result_stride);
  for (Ring& ring : rings_) ring.samples = workspace.take(ring.height * ring.stride);
  for (Vertical* vertical : {&lower_, &last_[0], &last_[1]})
    vertical->sums = workspace.take(widest_sums);
  result_line_ = workspace.take(result_stride);
  lines_.resize(most_taps);
  strands_.resize(static_cast<std::size_t>(largest_arity));
  cuts_.resize(static_cast<std::size_t>(line_samples<T>));
  edge_.resize(static_cast<std::size_t>(line_samples<T> + largest_arity));
}

template <class T>
void RowPipe<T>::next(T* out, bool stream, T* upcoming) {
  const Index row = next_result_++;
  if (stream && upcoming != nullptr) fetch_edges(upcoming, result_columns_.count());
  if (depth_ == 0) {
    input_.continued_row(row, result_columns_, out);
    return;
  }
  const std::size_t level = depth_ - 1;
  Vertical& now = last_[turn_];
  Vertical& after = last_[1 - turn_];
  turn_ = 1 - turn_;
  if (!ahead_) {
    open_vertical(level, row, now);
    combine_columns(now, 0, rings_[level].width);
  }
  ahead_ = row < last_result_;
  if (ahead_) open_vertical(level, row + 1, after);
  const Vertical* ahead = ahead_ && after.line == after.sums ? &after : nullptr;
  if (!displaced(level)) {
    emit(level, now.line, out, stream, ahead);
    return;
  }
  emit(level, now.line, result_line_, false, ahead);
  detail_.displacement->add(level, row, result_columns_, *detail_.relief, result_line_,
                            relief_line_);
  emit_line(result_line_, out, stream);
}

// Makes every row of the level up to `row` available in its ring.
template <class T>
void RowPipe<T>::advance(std::size_t level, Index row) {
  Ring& ring = rings_[level];
  for (; ring.next_row <= row; ++ring.next_row) {
    T* out = ring.row(ring.next_row);
    if (level == 0)
      input_.continued_row(ring.next_row, ring.columns, out);
    else
      compute_row(level - 1, ring.next_row, out);
  }
}

// Row `row` of level + 1, in a ring, from the rows of `level`.
template <class T>
void RowPipe<T>::compute_row(std::size_t level, Index row, T* out) {
  open_vertical(level, row, lower_);
  const Ring& ring = rings_[level];
  combine_columns(lower_, 0, ring.width);
  put_on(ring.strands, lower_.line);
  // The last vectors may reach into the slack.
  kernels_.weave(out, strands_.data(), rules_.x[level].arity, ring.turns, false);
  if (displaced(level))
    detail_.displacement->add(level, row, rings_[level + 1].columns, *detail_.relief, out,
                              relief_line_);
}

// The vertical filter of row `row` of level + 1; the rows it reads are made, and put in lines_.
template <class T>
void RowPipe<T>::open_vertical(std::size_t level, Index row, Vertical& vertical) {
  const PhasedRule<T>& rule = rules_.y[level];
  const Index q = floor_divide(row, rule.arity);
  const PhaseStencil<T>& stencil = rule.phases[static_cast<std::size_t>(row - rule.arity * q)];
  const Index taps = static_cast<Index>(stencil.weights.size());
  advance(level, q + stencil.first + taps - 1);
  const Ring& ring = rings_[level];
  for (Index i = 0; i < taps; ++i)
    lines_[static_cast<std::size_t>(i)] = ring.row(q + stencil.first + i);
  vertical.weights = stencil.weights.data();
  vertical.taps = static_cast<int>(taps);
  vertical.line = is_plain_one(stencil) ? lines_[0] : vertical.sums;
}

// The vertical filter of `count` columns from the first + `first` on. Its rows are in lines_.
template <class T>
void RowPipe<T>::combine_columns(const Vertical& vertical, Index first, Index count) {
  if (vertical.line != vertical.sums || count < 1) return;
  kernels_.combine(vertical.sums + first, lines_.data(), first, vertical.weights, vertical.taps,
                   count);
}

// Strands for the columns from `column` on, of the level that rule `level` makes, out of a row at
// address 0 whose first sample is that of the ring.
template <class T>
std::vector<typename RowPipe<T>::Placed> RowPipe<T>::strands_at(std::size_t level,
                                                                Index column) const {
  const PhasedRule<T>& rule = rules_.x[level];
  std::vector<Placed> strands;
  for (Index i = column; i < column + rule.arity; ++i) {
    const Index q = floor_divide(i, rule.arity);
    const PhaseStencil<T>& stencil = rule.phases[static_cast<std::size_t>(i - rule.arity * q)];
    strands.push_back({q + stencil.first - rings_[level].columns.first, stencil.weights.data(),
                       static_cast<int>(stencil.weights.size())});
  }
  return strands;
}

template <class T>
void RowPipe<T>::put_on(const std::vector<Placed>& strands, const T* line) {
  for (std::size_t i = 0; i < strands.size(); ++i)
    strands_[i] = {line + strands[i].offset, strands[i].weights, strands[i].taps};
}

template <class T>
const typename RowPipe<T>::Cut& RowPipe<T>::cut_at(std::size_t level, Index head) {
  Cut& cut = cuts_[static_cast<std::size_t>(head)];
  if (cut.turns >= 0) return cut;
  const Index arity = rules_.x[level].arity;
  const Index first = result_columns_.first;
  const Index count = result_columns_.count();
  cut.turns = (count - head) / arity;
  cut.tail = count - head - cut.turns * arity;
  cut.head_strands = strands_at(level, first);
  cut.strands = strands_at(level, first + head);
  cut.tail_strands = strands_at(level, first + count - cut.tail);
  return cut;
}

// Fewer samples than a cache line holds.
template <class T>
void RowPipe<T>::emit_edge(const std::vector<Placed>& strands, const T* line, Index count, T* out) {
  if (count < 1) return;
  const auto arity = static_cast<Index>(strands.size());
  put_on(strands, line);
  kernels_.weave(edge_.data(), strands_.data(), static_cast<int>(arity),
                 (count + arity - 1) / arity, false);
  std::copy_n(edge_.data(), count, out);
}

// A result row, and the vertical filter of the next one on the way.
template <class T>
void RowPipe<T>::emit(std::size_t level, const T* line, T* out, bool stream,
                      const Vertical* ahead) {
  const Index head = std::min(result_columns_.count(), before_line(out));
  const Cut& cut = cut_at(level, head);
  emit_edge(cut.head_strands, line, head, out);
  put_on(cut.strands, line);
  const auto arity = static_cast<Index>(cut.strands.size());
  const Index width = rings_[level].width;
  Index combined = 0;
  T* to = out + head;
  for (Index t = 0; t < cut.turns; t += run) {
    const Index turns = std::min(run, cut.turns - t);
    kernels_.weave(to, strands_.data(), static_cast<int>(arity), turns, stream);
    to += turns * arity;
    for (Index i = 0; i < arity; ++i) strands_[static_cast<std::size_t>(i)].line += turns;
    if (ahead == nullptr) continue;
    const Index columns = std::min(run, width - combined);
    combine_columns(*ahead, combined, columns);
    combined += columns;
  }
  if (ahead != nullptr) combine_columns(*ahead, combined, width - combined);
  emit_edge(cut.tail_strands, line, cut.tail, to);
}

template <class T>
void RowPipe<T>::emit_line(const T* line, T* out, bool stream) {
  const Index count = result_columns_.count();
  const Index head = std::min(count, before_line(out));
  std::copy_n(line, head, out);
  const T one = 1;
  const Strand<T> strand{line + head, &one, 1};
  kernels_.weave(out + head, &strand, 1, count - head, stream);
}

template class RowPipe<float>;
template class RowPipe<double>;

}  // namespace arete
