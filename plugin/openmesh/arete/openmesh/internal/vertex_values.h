// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "arete/openmesh/internal/components.h"
#include "arete/openmesh/internal/patch_evaluator.h"

namespace arete::openmesh::detail {

/// The range values are held in, besides that of their type.
struct ValueRange {
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
};

/// Fills `values`, one entry a new vertex, from the old ones. `values` may begin with them.
/// \pre rule is not `nearest`.
template <class Real, class T>
void refine_vertex_values(const Rebuild& rebuild,
                          const std::vector<PatchEvaluator<Real>>& evaluators, AttributeRule rule,
                          ValueRange range, const std::vector<T>& old, std::vector<T>& values) {
  using C = Components<T>;
  using Scalar = typename C::Scalar;
  const bool bounded = range.lowest > -std::numeric_limits<double>::infinity();
  const auto lowest = static_cast<Real>(range.lowest);
  const auto highest = static_cast<Real>(range.highest);
  for (std::size_t p = 0; p < rebuild.patches.size(); ++p) {
    const RefinedPatch& patch = rebuild.patches[p];
    std::vector<Grid<Real>> planes;
    for (std::size_t k = 0; k < C::count; ++k) {
      Grid<Real>& plane = planes.emplace_back(patch.coarse.extent);
      for (std::size_t i = 0; i < patch.coarse.vertices.size(); ++i)
        plane.samples()[i] =
            static_cast<Real>(C::get(old[static_cast<std::size_t>(patch.coarse.vertices[i])], k));
    }
    evaluators[p].evaluate(rule, planes, [&](Index r, std::span<const Real* const> rows) {
      std::vector<int> vertices(static_cast<std::size_t>(patch.cols.fine()));
      patch.row_vertices(r, vertices);
      for (std::size_t c = 0; c < vertices.size(); ++c) {
        T& value = values[static_cast<std::size_t>(vertices[c])];
        for (std::size_t k = 0; k < C::count; ++k) {
          Real x = rows[k][c];
          if (bounded) x = std::clamp(x, lowest, highest);
          C::set(value, k, rounded<Scalar>(x));
        }
      }
    });
  }
  for (const auto& [old_number, new_number] : rebuild.lone_vertices)
    values[static_cast<std::size_t>(new_number)] = old[static_cast<std::size_t>(old_number)];
}

}  // namespace arete::openmesh::detail
