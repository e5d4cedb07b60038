// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "arete/field/boundary.h"
#include "arete/meshlab/fields.h"
#include "arete/meshlab/subdivide.h"

namespace arete::meshlab {

// Pieces of the dialogs' texts.
[[nodiscard]] const std::string& citation();
[[nodiscard]] const std::string& what_is_a_grid();
[[nodiscard]] const std::string& layer_matrix();

/// Boundary: extrapolate, clamp, reflect, periodic, none, as far as `last`.
[[nodiscard]] Field boundary_field(Boundary last);
[[nodiscard]] Boundary chosen_boundary(const Values& values);

/// Coordinates: heights, or x, y and z.
[[nodiscard]] Field coordinates_field();
[[nodiscard]] Coordinates chosen_coordinates(const Values& values);

/// KeepQuads.
[[nodiscard]] Field quads_field(bool fallback);

}  // namespace arete::meshlab
