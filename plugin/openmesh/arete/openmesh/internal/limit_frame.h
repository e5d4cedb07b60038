// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "arete/openmesh/internal/patch_evaluator.h"
#include "arete/scheme/stencil.h"

namespace arete::openmesh::detail {

/// Limit and derivative of a scheme at its samples; nothing where it is not certified C^1 or where
/// samples do not sit at the parameter of their limit (tau != 0).
struct LimitStencils {
  Stencil limit;
  Stencil derivative;
};
[[nodiscard]] std::optional<LimitStencils> limit_stencils(const Scheme& scheme);

/// The normal of the limit surface at every fine vertex of a patch: the cross product of its exact
/// partial derivatives, of length 1, on the side the faces look to, and (0, 0, 0) where the
/// derivatives are parallel. False if there is no normal for every vertex (boundary none).
///
/// planes: the old x, y, z.
[[nodiscard]] bool limit_normals(
    const RefinedPatch& patch, const RebuildOptions& options, const LimitStencils& along_rows,
    const LimitStencils& along_cols, std::array<const Grid<double>*, 3> planes, int threads,
    const std::function<void(Index r, Index c, const std::array<double, 3>&)>& sink);

}  // namespace arete::openmesh::detail
