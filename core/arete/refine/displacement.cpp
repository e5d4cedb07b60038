// SPDX-License-Identifier: MIT
#include "arete/refine/displacement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "arete/refine/closing_gain.h"

namespace arete {
namespace {

void check(const Detail& detail) {
  if (!(detail.roughness >= 0 && detail.roughness <= 2))
    throw InvalidField("detail: roughness " + std::to_string(detail.roughness) +
                       " is outside 0..2; 0.5 to 0.9 looks like terrain");
  if (!(detail.relief >= 0 && std::isfinite(detail.relief)))
    throw InvalidField("detail: relief " + std::to_string(detail.relief) +
                       " is not a number of 0 or more; 0.15 is usual");
}

Index folded(Index k, Index turn) { return turn == 0 ? k : k - turn * floor_divide(k, turn); }

}  // namespace

std::vector<LevelLattice> level_lattices(const AxisPlan& plan) {
  std::vector<LevelLattice> lattices;
  Rational first = 0;
  Rational spacing = 1;
  const bool turns = plan.boundary() == Boundary::periodic;
  Index count = plan.input_count();
  for (const LevelRule& rule : plan.rules()) {
    // A filter leaves samples where they are; what it makes is not displaced.
    LevelLattice lattice;
    if (rule.arity > 1) {
      const Rational tau = rule.symbol.derivative().sum() / rule.arity;
      spacing /= rule.arity;
      first -= tau * spacing;
      count *= rule.arity;
      lattice.step = is_integer(tau) ? rule.arity : 0;
      lattice.old = is_integer(tau) ? static_cast<Index>(floor(tau)) : 0;
    }
    lattice.first = to_double(first);
    lattice.spacing = to_double(spacing);
    lattice.turn = turns ? count : 0;
    lattices.push_back(lattice);
  }
  return lattices;
}

ReliefPosition relief_position(const LevelLattice& lattice, Index k, Index count) {
  const double position = lattice.first + static_cast<double>(k) * lattice.spacing;
  const double whole = std::floor(position);
  const auto index = static_cast<Index>(whole);
  if (lattice.turn > 0) return {folded(index, count), position - whole};
  if (index < 0) return {0, 0};
  if (index >= count - 1) return {count - 1, 0};
  return {index, position - whole};
}

template <class T>
Displacement<T>::Displacement(const Detail& detail, const AxisPlan& x, const AxisPlan& y)
    : detail_(detail), cols_(x.input_count()), rows_(y.input_count()), y_(y) {
  check(detail);
  const std::vector<LevelLattice> along_x = level_lattices(x);
  const std::vector<LevelLattice> along_y = level_lattices(y);
  const auto spacing = [&](std::size_t l) {
    return std::sqrt(along_x[l].spacing * along_y[l].spacing);
  };
  levels_.resize(along_x.size());
  int number = 0;
  double first_spacing = 1;
  std::size_t last = 0;
  std::size_t before_last = 0;
  for (std::size_t l = 0; l < levels_.size(); ++l) {
    Level& level = levels_[l];
    if (x.rules()[l].arity == 1 && y.rules()[l].arity == 1) continue;
    level.number = ++number;
    if (number == 1) first_spacing = spacing(l);
    before_last = last;
    last = l;
    level.x = along_x[l];
    level.y = along_y[l];
    level.amplitude = static_cast<T>(
        detail.relief * std::pow(spacing(l) / first_spacing, detail.roughness) * noise_unit);
    const IndexRange columns = x.ranges()[l + 1];
    level.first_column = columns.first;
    for (Index c = columns.first; c <= columns.last; ++c) {
      const ReliefPosition at = relief_position(level.x, c, cols_);
      level.left.push_back(static_cast<std::int32_t>(at.index));
      level.fraction.push_back(static_cast<T>(at.fraction));
    }
  }
  if (number == 0) return;
  const ClosingGain gain = closing_gain(x, y, detail.roughness);
  levels_[last].amplitude *= static_cast<T>(gain.last);
  if (number > 1) levels_[before_last].amplitude *= static_cast<T>(gain.before_last);
}

template <class T>
IndexRange Displacement<T>::relief_rows(IndexRange outputs) const {
  const std::vector<IndexRange> ranges = y_.ranges_for(outputs);
  IndexRange rows{ranges.front().first, ranges.front().last};
  for (std::size_t l = 0; l < levels_.size(); ++l) {
    if (!displaces(l)) continue;
    const LevelLattice& lattice = levels_[l].y;
    const auto floor_of = [&](Index k) {
      return static_cast<Index>(
          std::floor(lattice.first + static_cast<double>(k) * lattice.spacing));
    };
    rows.first = std::min(rows.first, floor_of(ranges[l + 1].first));
    rows.last = std::max(rows.last, floor_of(ranges[l + 1].last) + 1);
  }
  if (y_.boundary() == Boundary::periodic) {
    // One turn is all there is.
    rows.last = std::min(rows.last, rows.first + rows_ - 1);
    return rows;
  }
  return {std::clamp(rows.first, Index{0}, rows_ - 1), std::clamp(rows.last, Index{0}, rows_ - 1)};
}

template <class T>
NoiseRow Displacement<T>::noise(const Level& level, Index row) const {
  return {detail_.seed, level.number, folded(row, level.y.turn)};
}

template <class T>
T Displacement<T>::at(std::size_t level, Index row, Index col, const LocalRelief<T>& relief) const {
  const Level& here = levels_[level];
  if (detail_.keep_samples && here.y.is_old(row) && here.x.is_old(col)) return T(0);
  const ReliefPosition y = relief_position(here.y, row, rows_);
  const ReliefPosition x = relief_position(here.x, col, cols_);
  const T* above = relief.row(y.index);
  const T* below = relief.row(y.index + 1);
  const T down = static_cast<T>(y.fraction);
  const T left = above[x.index] + down * (below[x.index] - above[x.index]);
  const T right = above[x.index + 1] + down * (below[x.index + 1] - above[x.index + 1]);
  const T around = left + static_cast<T>(x.fraction) * (right - left);
  return here.amplitude * around * static_cast<T>(noise(here, row).at(folded(col, here.x.turn)));
}

template <class T>
void Displacement<T>::add(std::size_t level, Index row, IndexRange columns,
                          const LocalRelief<T>& relief, T* samples, std::vector<T>& scratch) const {
  const Level& here = levels_[level];
  const ReliefPosition y = relief_position(here.y, row, rows_);
  const T* above = relief.row(y.index);
  const T* below = relief.row(y.index + 1);
  const T down = static_cast<T>(y.fraction);
  scratch.resize(static_cast<std::size_t>(cols_ + 1));
  T* line = scratch.data();
  for (Index c = 0; c <= cols_; ++c) line[c] = above[c] + down * (below[c] - above[c]);

  const bool old_row = detail_.keep_samples && here.y.is_old(row);
  const NoiseRow numbers = noise(here, row);
  constexpr Index block = 256;
  std::array<std::int32_t, block> xi;
  for (Index first = columns.first; first <= columns.last;) {
    // A block ends where a turn does, so that its columns are neighbours in it too.
    const Index start = folded(first, here.x.turn);
    Index count = std::min(block, columns.last - first + 1);
    if (here.x.turn > 0) count = std::min(count, here.x.turn - start);
    numbers.fill({start, start + count - 1}, xi.data());
    if (old_row)
      for (Index i = 0; i < count; ++i)
        if (here.x.is_old(first + i)) xi[static_cast<std::size_t>(i)] = 0;
    T* out = samples + (first - columns.first);
    const std::int32_t* left = here.left.data() + (first - here.first_column);
    const T* fraction = here.fraction.data() + (first - here.first_column);
    for (Index i = 0; i < count; ++i) {
      const T* at = line + left[i];
      const T around = at[0] + fraction[i] * (at[1] - at[0]);
      out[i] = out[i] + here.amplitude * around * static_cast<T>(xi[static_cast<std::size_t>(i)]);
    }
    first += count;
  }
}

template class Displacement<float>;
template class Displacement<double>;

}  // namespace arete
