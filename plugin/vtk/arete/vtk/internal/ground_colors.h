// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "arete/vtk/appearance.h"
#include "arete/vtk/internal/reduce.h"
#include "arete/vtk/internal/stage.h"

namespace arete::vtk {

/// The lowest and highest valid height.
[[nodiscard]] std::array<double, 2> height_range(const Surface& surface);

/// Colours by palette or colormap, one pixel a sample (the texture is left aside); of a missing
/// sample that of the lower end.
[[nodiscard]] Image ground_colors(const Stage& stage, const Appearance& appearance,
                                  const std::array<double, 2>& range);

/// The texture, and where it is not the ground's colours, which are those of the reduced surface;
/// `original` is the extent of the surface that was reduced.
[[nodiscard]] Image textured(const Texture& texture, const Image& ground,
                             const ReducedSurface& reduced, Extent original);

}  // namespace arete::vtk
