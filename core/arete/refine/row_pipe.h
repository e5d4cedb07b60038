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
  /// The filter of a row from some column on.
  struct Weaver {
    std::vector<Strand<T>> strands;
    /// For each phase of the rows: null where the vertical filter must be done beforehand.
    std::vector<Weave<T>> weaves;
    Weave<T> plain = nullptr;  ///< for a row that has been filtered vertically
  };
  /// The rows of one level that later rows may still need.
  struct Ring {
    IndexRange columns;
    Index height = 0;  ///< a power of two
    Index stride = 0;
    Index width = 0;     ///< columns.count(), made full vectors
    Index next_row = 0;  ///< not yet computed
    // Of the next level's next row.
    Index quotient = 0;
    std::size_t phase = 0;
    T* samples = nullptr;
    Weaver weaver;    ///< from the first column of the next level on
    Index count = 0;  ///< samples of the next level's rows, made whole vectors of turns

    [[nodiscard]] T* row(Index r) const { return samples + (r & (height - 1)) * stride; }
  };
  /// A result row in two: up to the first cache line, and the rest.
  struct Cut {
    bool made = false;
    Weaver before, after;
  };
  /// What a row of the next level is made of.
  struct Opened {
    std::size_t phase = 0;
    Warp<T> warp;
    Warp<T> sums;  ///< the warp filtered vertically, once that has been needed
  };

  [[nodiscard]] bool displaced(std::size_t level) const {
    return detail_.displacement != nullptr && detail_.displacement->displaces(level);
  }
  void advance(std::size_t level, Index row);
  void compute_row(std::size_t level, Index row, T* out);
  void emit(std::size_t level, T* out, bool stream);
  void emit_line(const T* line, T* out, bool stream);
  [[nodiscard]] Opened open_row(std::size_t level);
  void weave(std::size_t level, const Weaver& weaver, Opened& opened, T* out, Index count,
             bool stream);
  [[nodiscard]] Weaver weaver_at(std::size_t level, Index column) const;
  [[nodiscard]] const Cut& cut_at(std::size_t level, Index head);

  const PipeRules<T>& rules_;
  const InputWindow<T>& input_;
  const Kernels<T>& kernels_;
  Hook detail_;
  std::size_t depth_;
  std::vector<Ring> rings_;  ///< levels 0..depth-1
  IndexRange result_columns_;
  Index next_result_;
  T* sums_ = nullptr;         ///< a row filtered vertically, where that is done beforehand
  T* result_line_ = nullptr;  ///< a result row on its way through a displacement
  std::vector<const T*> lines_;
  std::vector<Cut> cuts_;  ///< by the samples before the first cache line
  std::vector<T> relief_line_;
};

}  // namespace arete
