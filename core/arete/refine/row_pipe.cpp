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
  Index total = 0;
  Index widest_sums = 0;
  std::size_t most_taps = 1;
  for (std::size_t level = 0; level < depth_; ++level) {
    Ring& ring = rings_[level];
    ring.columns = column_ranges[level];
    ring.width = full_vectors<T>(ring.columns.count());
    ring.height =
        static_cast<Index>(std::bit_ceil(static_cast<std::size_t>(rows_at_hand(rules.y[level]))));
    ring.stride = ring_stride<T>(ring.columns.count(), level > 0 ? rules.x[level - 1].arity : 1);
    ring.next_row = row_ranges[level].first;
    ring.quotient = floor_divide(row_ranges[level + 1].first, rules.y[level].arity);
    ring.phase = static_cast<std::size_t>(row_ranges[level + 1].first -
                                          rules.y[level].arity * ring.quotient);
    const Index arity = rules.x[level].arity;
    ring.weaver = weaver_at(level, column_ranges[level + 1].first);
    ring.count = arity * full_vectors<T>((column_ranges[level + 1].count() + arity - 1) / arity);
    total += ring.height * ring.stride;
    widest_sums = std::max(widest_sums, ring.stride);
    for (const PhaseStencil<T>& phase : rules.y[level].phases)
      most_taps = std::max(most_taps, phase.weights.size());
  }
  const Index result_stride = Workspace<T>::stride(result_columns_.count(), kernel_slack);
  workspace.restart(total + widest_sums + result_stride);
  for (Ring& ring : rings_) ring.samples = workspace.take(ring.height * ring.stride);
  sums_ = workspace.take(widest_sums);
  result_line_ = workspace.take(result_stride);
  lines_.resize(most_taps);
  cuts_.resize(static_cast<std::size_t>(line_samples<T>));
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
  if (!displaced(level)) {
    emit(level, out, stream);
    return;
  }
  emit(level, result_line_, false);
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
  Opened opened = open_row(level);
  const Ring& ring = rings_[level];
  // The last vectors may reach into the slack.
  weave(level, ring.weaver, opened, out, ring.count, false);
  if (displaced(level))
    detail_.displacement->add(level, row, rings_[level + 1].columns, *detail_.relief, out,
                              relief_line_);
}

// Makes the rows that the next row of level + 1 reads, and puts them in lines_. Rows come in order.
template <class T>
typename RowPipe<T>::Opened RowPipe<T>::open_row(std::size_t level) {
  const PhasedRule<T>& rule = rules_.y[level];
  Ring& ring = rings_[level];
  const Index q = ring.quotient;
  const std::size_t phase = ring.phase++;
  if (ring.phase == rule.phases.size()) {
    ring.phase = 0;
    ++ring.quotient;
  }
  const PhaseStencil<T>& stencil = rule.phases[phase];
  const Index taps = static_cast<Index>(stencil.weights.size());
  advance(level, q + stencil.first + taps - 1);
  for (Index i = 0; i < taps; ++i)
    lines_[static_cast<std::size_t>(i)] = ring.row(q + stencil.first + i);
  return {
      phase,
      {lines_.data(), stencil.weights.data(), is_plain_one(stencil) ? 0 : static_cast<int>(taps)},
      {}};
}

template <class T>
void RowPipe<T>::weave(std::size_t level, const Weaver& weaver, Opened& opened, T* out, Index count,
                       bool stream) {
  const auto arity = static_cast<int>(weaver.strands.size());
  if (const Weave<T> fused = weaver.weaves[opened.phase]) {
    fused(out, opened.warp, weaver.strands.data(), arity, count, stream);
    return;
  }
  if (opened.sums.lines == nullptr) {
    kernels_.combine(sums_, opened.warp.lines, opened.warp.weights, opened.warp.taps,
                     rings_[level].width);
    opened.sums.lines = &sums_;
  }
  weaver.plain(out, opened.sums, weaver.strands.data(), arity, count, stream);
}

// The filter of the columns from `column` on, of the level that rule `level` makes, out of rows
// that begin where the ring's do.
template <class T>
typename RowPipe<T>::Weaver RowPipe<T>::weaver_at(std::size_t level, Index column) const {
  const PhasedRule<T>& rule = rules_.x[level];
  Weaver weaver;
  for (Index i = column; i < column + rule.arity; ++i) {
    const Index q = floor_divide(i, rule.arity);
    const PhaseStencil<T>& stencil = rule.phases[static_cast<std::size_t>(i - rule.arity * q)];
    weaver.strands.push_back({q + stencil.first - rings_[level].columns.first,
                              stencil.weights.data(), static_cast<int>(stencil.weights.size())});
  }
  const auto arity = static_cast<int>(rule.arity);
  weaver.plain = kernels_.weave_for(0, weaver.strands.data(), arity);
  for (const PhaseStencil<T>& stencil : rules_.y[level].phases) {
    const auto taps = static_cast<int>(stencil.weights.size());
    Weave<T> weave = nullptr;
    if (is_plain_one(stencil))
      weave = weaver.plain;
    else if (taps > 0)  // 0 taps are zeros here, but the plain line to a warp
      weave = kernels_.weave_for(taps, weaver.strands.data(), arity);
    weaver.weaves.push_back(weave);
  }
  return weaver;
}

template <class T>
const typename RowPipe<T>::Cut& RowPipe<T>::cut_at(std::size_t level, Index head) {
  Cut& cut = cuts_[static_cast<std::size_t>(head)];
  if (cut.made) return cut;
  cut.before = weaver_at(level, result_columns_.first);
  cut.after = weaver_at(level, result_columns_.first + head);
  cut.made = true;
  return cut;
}

template <class T>
void RowPipe<T>::emit(std::size_t level, T* out, bool stream) {
  Opened opened = open_row(level);
  const Index count = result_columns_.count();
  // Short rows do not earn what a second beginning costs.
  const Index head = stream || count > 512 ? std::min(count, before_line(out)) : 0;
  const Cut& cut = cut_at(level, head);
  if (head > 0) weave(level, cut.before, opened, out, head, false);
  weave(level, cut.after, opened, out + head, count - head, stream);
}

template <class T>
void RowPipe<T>::emit_line(const T* line, T* out, bool stream) {
  const Index count = result_columns_.count();
  const Index head = std::min(count, before_line(out));
  std::copy_n(line, head, out);
  const T one = 1;
  const Strand<T> strand{head, &one, 1};
  const Weave<T> copy = kernels_.weave_for(0, &strand, 1);
  copy(out + head, {&line, nullptr, 0}, &strand, 1, count - head, stream);
}

template class RowPipe<float>;
template class RowPipe<double>;

}  // namespace arete
