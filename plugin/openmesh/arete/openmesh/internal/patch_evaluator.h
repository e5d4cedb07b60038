// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "arete/openmesh/attribute_rule.h"
#include "arete/openmesh/internal/rebuild.h"
#include "arete/refine/refiner.h"

namespace arete::openmesh::detail {

/// Takes planes of old values of one patch to the rows of new ones, a band of rows at a time, so
/// that no plane of the fine level is ever held. Real is float or double. With more than one thread
/// bands are made at the same time, and the sink must bear being called so for different rows.
template <class Real>
class PatchEvaluator {
 public:
  /// Row r of every plane: rows[k][c] belongs to fine vertex (r, c).
  using Sink = std::function<void(Index r, std::span<const Real* const> rows)>;

  PatchEvaluator(const RefinedPatch& patch, int threads);

  /// By the scheme, or bilinearly. \pre rule is not `nearest`.
  void evaluate(AttributeRule rule, std::span<const Grid<Real>> planes, const Sink& sink) const;

 private:
  void by_scheme(std::span<const Grid<Real>> planes, const Sink& sink) const;
  void bilinearly(std::span<const Grid<Real>> planes, const Sink& sink) const;

  const RefinedPatch& patch_;
  int threads_;
  Refiner<Real> refiner_;
};

/// Bands of rows through prepared refiners, one per plane, all of the same result size.
template <class Real>
void refine_in_bands(std::span<const Refiner<Real>* const> refiners,
                     std::span<const Grid<Real>* const> planes, int threads,
                     const typename PatchEvaluator<Real>::Sink& sink);

}  // namespace arete::openmesh::detail
