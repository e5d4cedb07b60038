// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "arete/refine/axis_plan.h"

namespace arete {

/// Refinement in its plainest form, one whole level after the other, over any ring R that rationals
/// convert to: exact rationals (what the oracles are compared with) and float or double (what the
/// engine must equal to the last bit). No missing samples.
template <class R>
[[nodiscard]] R continued_value(const std::vector<R>& samples, Boundary boundary, Index index) {
  const Continuation from = continued(boundary, index, static_cast<Index>(samples.size()));
  const R& near = samples[static_cast<std::size_t>(from.near)];
  if (from.steps == 0) return near;
  return near + R(from.steps) * (near - samples[static_cast<std::size_t>(from.far)]);
}

/// One level: the samples `fine` of rule applied to `coarse`, whose first sample has index
/// `origin`.
template <class R>
[[nodiscard]] std::vector<R> apply_rule(const PhasedRule<R>& rule, const std::vector<R>& coarse,
                                        Index origin, IndexRange fine) {
  std::vector<R> result;
  for (Index k = fine.first; k <= fine.last; ++k) {
    const Index q = floor_divide(k, rule.arity);
    const PhaseStencil<R>& stencil = rule.phases[static_cast<std::size_t>(k - rule.arity * q)];
    R sum(0);
    for (std::size_t i = 0; i < stencil.weights.size(); ++i) {
      const R& sample = coarse[static_cast<std::size_t>(q + stencil.first - origin) + i];
      sum = i == 0 ? R(stencil.weights[i] * sample) : R(sum + stencil.weights[i] * sample);
    }
    result.push_back(sum);
  }
  return result;
}

/// A whole axis.
template <class R>
[[nodiscard]] std::vector<R> refine_reference(const AxisPlan& plan, const std::vector<R>& samples) {
  std::vector<R> level;
  for (Index i = plan.ranges().front().first; i <= plan.ranges().front().last; ++i)
    level.push_back(continued_value(samples, plan.boundary(), i));
  for (std::size_t l = 0; l < plan.rules().size(); ++l)
    level = apply_rule(PhasedRule<R>(plan.rules()[l]), level, plan.ranges()[l].first,
                       plan.ranges()[l + 1]);
  return level;
}

template <class R>
using Table = std::vector<std::vector<R>>;

template <class R>
[[nodiscard]] Table<R> transposed(const Table<R>& table) {
  if (table.empty()) return {};
  Table<R> result(table.front().size(), std::vector<R>(table.size()));
  for (std::size_t i = 0; i < table.size(); ++i)
    for (std::size_t j = 0; j < table[i].size(); ++j) result[j][i] = table[i][j];
  return result;
}

/// A grid, in the order of the engine: ghost rows, ghost columns, then level by level the vertical
/// and the horizontal rule, and after_level(rule, table), which may change the samples that the
/// rule of that number made. \pre both plans have equally many rules (AxisPlan::pad_levels).
template <class R, class AfterLevel>
[[nodiscard]] Table<R> refine_reference(const AxisPlan& x, const AxisPlan& y,
                                        const Table<R>& samples, AfterLevel&& after_level) {
  const auto along_columns = [](const Table<R>& table, auto&& axis) {
    Table<R> columns = transposed(table);
    for (auto& column : columns) column = axis(column);
    return transposed(columns);
  };
  const auto along_rows = [](Table<R> table, auto&& axis) {
    for (auto& row : table) row = axis(row);
    return table;
  };
  const auto ghosts = [](const AxisPlan& plan) {
    return [&plan](const std::vector<R>& line) {
      std::vector<R> extended;
      for (Index i = plan.ranges().front().first; i <= plan.ranges().front().last; ++i)
        extended.push_back(continued_value(line, plan.boundary(), i));
      return extended;
    };
  };
  const auto rule = [](const AxisPlan& plan, std::size_t l) {
    return [&plan, l, phased = PhasedRule<R>(plan.rules()[l])](const std::vector<R>& line) {
      return apply_rule(phased, line, plan.ranges()[l].first, plan.ranges()[l + 1]);
    };
  };
  Table<R> level = along_rows(along_columns(samples, ghosts(y)), ghosts(x));
  for (std::size_t l = 0; l < x.rules().size(); ++l) {
    level = along_rows(along_columns(level, rule(y, l)), rule(x, l));
    after_level(l, level);
  }
  return level;
}

template <class R>
[[nodiscard]] Table<R> refine_reference(const AxisPlan& x, const AxisPlan& y,
                                        const Table<R>& samples) {
  return refine_reference(x, y, samples, [](std::size_t, Table<R>&) {});
}

}  // namespace arete
