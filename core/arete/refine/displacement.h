// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "arete/refine/axis_plan.h"
#include "arete/refine/detail.h"
#include "arete/refine/local_relief.h"
#include "arete/refine/noise.h"

namespace arete {

/// Where the samples of one level lie along one axis, and which of them are old: sample k lies at
/// first + k spacing among the input's, and stands on a sample of the level before if k - old is a
/// multiple of step (step 0: none does).
struct LevelLattice {
  double first = 0;
  double spacing = 1;
  Index step = 1;
  Index old = 0;
  Index turn = 0;  ///< samples a turn of a periodic axis; 0: not periodic

  [[nodiscard]] bool is_old(Index k) const {
    return step == 1 || (step > 1 && floor_divide(k - old, step) * step == k - old);
  }
};

/// Lattices of all levels of an axis, in the order of its rules.
[[nodiscard]] std::vector<LevelLattice> level_lattices(const AxisPlan& plan);

/// A position among the input's samples, as the one before it and the rest: between relief.row(i)
/// and relief.row(i + 1), fraction t. Beyond the ends the end itself, or round when periodic.
struct ReliefPosition {
  Index index = 0;
  double fraction = 0;
};
[[nodiscard]] ReliefPosition relief_position(const LevelLattice& lattice, Index k, Index count);

/// Detail for one refinement: all that does not depend on the samples (see Detail).
template <class T>
class Displacement {
 public:
  /// \throws InvalidField for a roughness outside 0..2, or a relief that is negative or not finite.
  Displacement(const Detail& detail, const AxisPlan& x, const AxisPlan& y);

  /// Whether rule number `level` (from 0) is followed by a displacement.
  [[nodiscard]] bool displaces(std::size_t level) const { return levels_[level].number > 0; }

  /// The input rows whose relief is read for the results number `outputs` (rows, 0-based).
  [[nodiscard]] IndexRange relief_rows(IndexRange outputs) const;

  /// What is added to sample (row, col) of the level that rule `level` makes. The plain truth.
  [[nodiscard]] T at(std::size_t level, Index row, Index col, const LocalRelief<T>& relief) const;

  /// Adds it to the samples `columns` of such a row. `scratch` is grown as needed.
  void add(std::size_t level, Index row, IndexRange columns, const LocalRelief<T>& relief,
           T* samples, std::vector<T>& scratch) const;

 private:
  struct Level {
    int number = 0;  ///< counted from 1; 0: no displacement
    T amplitude = 0;
    LevelLattice x, y;
    Index first_column = 0;          ///< of the tables
    std::vector<std::int32_t> left;  ///< per column: the input sample left of it
    std::vector<T> fraction;
  };
  [[nodiscard]] NoiseRow noise(const Level& level, Index row) const;

  Detail detail_;
  const Index cols_;
  const Index rows_;
  AxisPlan y_;
  std::vector<Level> levels_;
};

}  // namespace arete
