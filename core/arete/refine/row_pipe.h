// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "arete/refine/axis_plan.h"
#include "arete/refine/displacement.h"
#include "arete/refine/input_window.h"
#include "arete/refine/kernel/kernel.h"
#include "arete/refine/workspace.h"

namespace arete {

/// The rules of a refinement, level by level, in the arithmetic of the samples. Both axes have
/// equally many levels (AxisPlan::pad_levels).
template <class T>
struct PipeRules {
  std::vector<PhasedRule<T>> x;
  std::vector<PhasedRule<T>> y;
};

/// The engine: k levels as k pipes of rows in series. Each level takes the rows of the level before
/// in order and gives its own in order, holding only as many as its stencils are tall, so no
/// intermediate level ever exists and every row is still in cache when it is used. A level filters
/// vertically first (on the narrower rows), then horizontally.
///
/// Working memory: O(sum over levels of width x stencil height). The value of a result is one fixed
/// expression of the input, whatever the rows and columns it is computed with.
template <class T>
class RowPipe {
 public:
  /// What is added between the levels; both null for none.
  struct Hook {
    const Displacement<T>* displacement = nullptr;
    const LocalRelief<T>* relief = nullptr;
  };

  /// A pipe for the results number `rows` and `columns` (0-based) of the plans. All that is given
  /// must outlive it; the workspace serves one pipe at a time.
  RowPipe(const PipeRules<T>& rules, const AxisPlan& y, const AxisPlan& x,
          const InputWindow<T>& input, IndexRange rows, IndexRange columns, Workspace<T>& workspace,
          Hook detail = {});

  /// Writes the next result row (columns.count() samples). With `stream` it goes past the cache as
  /// far as it fills whole cache lines; see Kernels::fence. `upcoming` is where the row after it
  /// will go, so that the lines it fills in part can be fetched in time.
  void next(T* out, bool stream = false, T* upcoming = nullptr);

 private:
  /// A strand of some line, which begins so many samples after the line does.
  struct Placed {
    Index offset = 0;
    const T* weights = nullptr;
    int taps = 0;
  };
  /// The rows of one level that later rows may still need.
  struct Ring {
    IndexRange columns;
    Index height = 0;  ///< a power of two
    Index stride = 0;
    Index width = 0;     ///< columns.count(), made full vectors
    Index next_row = 0;  ///< not yet computed
    T* samples = nullptr;
    std::vector<Placed> strands;  ///< for the first column of the next level
    Index turns = 0;              ///< of the next level's rows, made full vectors

    [[nodiscard]] T* row(Index r) const { return samples + (r & (height - 1)) * stride; }
  };
  /// A result row in three: up to the first cache line, whole turns, and the rest.
  struct Cut {
    Index turns = -1;  ///< not cut yet
    Index tail = 0;
    std::vector<Placed> head_strands, strands, tail_strands;
  };
  /// A row of a level after the vertical filter: `sums` belongs to column `first`.
  struct Vertical {
    const T* weights = nullptr;
    int taps = 0;
    T* sums = nullptr;
    const T* line = nullptr;  ///< the sums, or the row itself where the stencil is a plain 1
  };

  [[nodiscard]] bool displaced(std::size_t level) const {
    return detail_.displacement != nullptr && detail_.displacement->displaces(level);
  }
  void advance(std::size_t level, Index row);
  void compute_row(std::size_t level, Index row, T* out);
  void open_vertical(std::size_t level, Index row, Vertical& vertical);
  void combine_columns(const Vertical& vertical, Index first, Index count);
  [[nodiscard]] std::vector<Placed> strands_at(std::size_t level, Index column) const;
  void put_on(const std::vector<Placed>& strands, const T* line);
  void emit(std::size_t level, const T* line, T* out, bool stream, const Vertical* ahead);
  [[nodiscard]] const Cut& cut_at(std::size_t level, Index head);
  void emit_edge(const std::vector<Placed>& strands, const T* line, Index count, T* out);
  void emit_line(const T* line, T* out, bool stream);

  const PipeRules<T>& rules_;
  const InputWindow<T>& input_;
  const Kernels<T>& kernels_;
  Hook detail_;
  std::size_t depth_;
  std::vector<Ring> rings_;  ///< levels 0..depth-1
  IndexRange result_columns_;
  Index next_result_;
  Index last_result_;
  // Never copied: a copy of words just written would wait for the streamed stores before them.
  Vertical lower_;            ///< of the levels before the last
  Vertical last_[2];          ///< of the last level: a row's and the next one's, in turn
  int turn_ = 0;              ///< which of them belongs to the next result row
  bool ahead_ = false;        ///< whether it is made already
  T* result_line_ = nullptr;  ///< a result row on its way through a displacement
  std::vector<const T*> lines_;
  std::vector<Strand<T>> strands_;  ///< on the line at hand
  std::vector<Cut> cuts_;           ///< by the samples before the first cache line
  std::vector<T> edge_;             ///< turns at the ends of a row
  std::vector<T> relief_line_;
};

}  // namespace arete
