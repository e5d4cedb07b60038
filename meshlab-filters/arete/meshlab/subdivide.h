// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "arete/field/boundary.h"
#include "arete/meshlab/mesh_arrays.h"
#include "arete/meshlab/progress.h"
#include "arete/refine/detail.h"
#include "arete/scheme/scheme.h"

namespace arete::meshlab {

/// What a scheme is applied to.
enum class Coordinates {
  heights,  ///< z; x and y are interpolated linearly at the exact place of every new vertex
  all       ///< x, y and z
};

struct SubdivideOptions {
  int levels = 1;
  Boundary boundary = Boundary::extrapolate;  ///< of open rims; what wraps is periodic anyway
  Coordinates coordinates = Coordinates::heights;
  std::optional<Detail> detail{};  ///< random, added to the heights level by level
};

/// Refines every grid of the mesh by the scheme along rows and columns.
///
/// Old vertices stay under their numbers as the new vertices nearest to their places; with an
/// interpolating scheme they do not move. A grid of H x W vertices becomes one of
/// (2^L (H-1) + 1) x (2^L (W-1) + 1) for binary schemes whose new samples sit at old ones; dual
/// schemes make a row less. Channels are blended bilinearly; wedges inside the old cell, or inside
/// the old triangle where a seam runs along its diagonal. New diagonals follow the old ones, new
/// triangles look to the side the old ones do. Vertices without faces stay as they are.
///
/// \throws InvalidField for what surface_patches() refuses, boundary periodic for all coordinates
/// of an open grid, boundary none on too small a grid, and results that would not fit the memory;
/// Cancelled. The same bits whatever the number of threads.
[[nodiscard]] RefinedMesh subdivided(const MeshArrays& mesh, const Scheme& scheme,
                                     const SubdivideOptions& options, Report& report);

}  // namespace arete::meshlab
