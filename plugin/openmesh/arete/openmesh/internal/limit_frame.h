// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>

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

/// How a mesh is refined, with the limit stencils of both schemes at the end if `on_limit`.
/// \throws InvalidField if one of them has no certified limit.
[[nodiscard]] RebuildOptions rebuild_options(const Scheme& along_rows, const Scheme& along_cols,
                                             Boundaries boundaries, int levels, bool on_limit);

/// The normal of the limit surface at every fine vertex of a patch: the cross product of its exact
/// partial derivatives, of length 1, on the side the faces look to, and (0, 0, 0) where the
/// derivatives are parallel. False if there is no normal for every vertex (boundary none). With
/// more than one thread the sink is called for several rows at the same time.
///
/// planes: the old x, y, z.
[[nodiscard]] bool limit_normals(
    const RefinedPatch& patch, const RebuildOptions& options, const LimitStencils& along_rows,
    const LimitStencils& along_cols, std::array<const Grid<double>*, 3> planes, int threads,
    const std::function<void(Index r, std::span<const std::array<double, 3>> normals)>& sink);

}  // namespace arete::openmesh::detail
