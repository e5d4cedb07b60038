// SPDX-License-Identifier: MIT
#include "arete/refine/row_pipe.h"

#include <algorithm>

#include "arete/refine/combine.h"

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

}  // namespace

template <class T>
RowPipe<T>::RowPipe(const std::vector<PhasedRule<T>>& y_rules, const AxisPlan& y,
                    const std::vector<PhasedRule<T>>& x_rules, const AxisPlan& x,
                    const InputWindow<T>& input, IndexRange outputs, Hook detail)
    : y_rules_(y_rules),
      x_rules_(x_rules),
      input_(input),
      detail_(detail),
      x_boundary_(x.boundary()),
      depth_(y_rules.size()),
      rings_(depth_),
      result_columns_(x.ranges().back()),
      next_result_(y.ranges().back().first + outputs.first) {
  const std::vector<IndexRange> rows = y.ranges_for(outputs);
  Index widest = result_columns_.count();
  std::size_t most_taps = 1;
  for (std::size_t level = 0; level < depth_; ++level) {
    Ring& ring = rings_[level];
    ring.columns = x.ranges()[level];
    ring.height = rows_at_hand(y_rules[level]);
    ring.next_row = rows[level].first;
    ring.samples.resize(static_cast<std::size_t>(ring.height * ring.columns.count()));
    widest = std::max(widest, ring.columns.count());
    for (const auto* rule : {&y_rules[level], &x_rules[level]})
      for (const PhaseStencil<T>& phase : rule->phases)
        most_taps = std::max(most_taps, phase.weights.size());
  }
  column_sums_.resize(static_cast<std::size_t>(widest));
  phase_line_.resize(static_cast<std::size_t>(widest));
  other_line_.resize(static_cast<std::size_t>(widest));
  lines_.resize(most_taps);
}

template <class T>
void RowPipe<T>::next(T* out) {
  const Index row = next_result_++;
  if (depth_ == 0)
    read_input_row(row, out);
  else
    compute_row(depth_ - 1, row, out);
}

// Makes every row of the level up to `row` available in its ring.
template <class T>
void RowPipe<T>::advance(std::size_t level, Index row) {
  Ring& ring = rings_[level];
  for (; ring.next_row <= row; ++ring.next_row) {
    if (level == 0)
      read_input_row(ring.next_row, ring.row(ring.next_row));
    else
      compute_row(level - 1, ring.next_row, ring.row(ring.next_row));
  }
}

template <class T>
void RowPipe<T>::read_input_row(Index row, T* out) {
  const IndexRange columns = depth_ == 0 ? result_columns_ : rings_[0].columns;
  const Index count = input_.source_extent().cols;
  column_sums_.resize(std::max(column_sums_.size(), static_cast<std::size_t>(count)));
  T* line = column_sums_.data();
  input_.continued_row(row, line);
  for (Index c = columns.first; c <= columns.last; ++c) {
    const Continuation from = continued(x_boundary_, c, count);
    out[c - columns.first] =
        from.steps == 0
            ? line[from.near]
            : line[from.near] + static_cast<T>(from.steps) * (line[from.near] - line[from.far]);
  }
}

// Row `row` of level + 1 from the rows of `level`.
template <class T>
void RowPipe<T>::compute_row(std::size_t level, Index row, T* out) {
  filter_row(level, row, out);
  if (detail_.displacement == nullptr || !detail_.displacement->displaces(level)) return;
  const IndexRange columns = level + 1 == depth_ ? result_columns_ : rings_[level + 1].columns;
  detail_.displacement->add(level, row, columns, *detail_.relief, out, relief_line_);
}

template <class T>
void RowPipe<T>::filter_row(std::size_t level, Index row, T* out) {
  const PhasedRule<T>& vertical = y_rules_[level];
  const Index q = floor_divide(row, vertical.arity);
  const PhaseStencil<T>& stencil =
      vertical.phases[static_cast<std::size_t>(row - vertical.arity * q)];
  const int rows = static_cast<int>(stencil.weights.size());
  advance(level, q + stencil.first + rows - 1);
  Ring& ring = rings_[level];
  for (int i = 0; i < rows; ++i)
    lines_[static_cast<std::size_t>(i)] = ring.row(q + stencil.first + i);
  T* sums = column_sums_.data();
  combine(sums, lines_.data(), stencil.weights.data(), rows, ring.columns.count());

  const PhasedRule<T>& horizontal = x_rules_[level];
  const IndexRange columns = level + 1 == depth_ ? result_columns_ : rings_[level + 1].columns;
  // The columns of phase r are k = m t + r for t in [first, last].
  const auto turns = [&](Index r) {
    return IndexRange{ceil_divide(columns.first - r, horizontal.arity),
                      floor_divide(columns.last - r, horizontal.arity)};
  };
  const auto filter = [&](Index r, IndexRange t, T* line) {
    const PhaseStencil<T>& phase = horizontal.phases[static_cast<std::size_t>(r)];
    const int taps = static_cast<int>(phase.weights.size());
    for (int i = 0; i < taps; ++i)
      lines_[static_cast<std::size_t>(i)] = sums + (t.first + phase.first + i - ring.columns.first);
    combine(line, lines_.data(), phase.weights.data(), taps, t.count());
  };
  if (horizontal.arity == 1) {
    filter(0, columns, out);
    return;
  }
  if (horizontal.arity == 2) {
    const IndexRange even = turns(0);
    const IndexRange odd = turns(1);
    filter(0, even, phase_line_.data());
    filter(1, odd, other_line_.data());
    // Either line may begin or end one sample before the other.
    const bool odd_first = odd.first < even.first;
    if (odd_first) out[0] = other_line_[0];
    T* paired = out + (odd_first ? 1 : 0);
    const T* odd_line = other_line_.data() + (odd_first ? 1 : 0);
    const Index pairs = std::min(even.count(), odd.count() - (odd_first ? 1 : 0));
    interleave(paired, phase_line_.data(), odd_line, pairs);
    if (even.count() > pairs) paired[2 * pairs] = phase_line_[static_cast<std::size_t>(pairs)];
    return;
  }
  for (Index r = 0; r < horizontal.arity; ++r) {
    const IndexRange t = turns(r);
    if (t.count() < 1) continue;
    filter(r, t, phase_line_.data());
    scatter(out + (horizontal.arity * t.first + r - columns.first), phase_line_.data(),
            horizontal.arity, t.count());
  }
}

template class RowPipe<float>;
template class RowPipe<double>;

}  // namespace arete
