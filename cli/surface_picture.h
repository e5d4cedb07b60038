// SPDX-License-Identifier: MIT
#pragma once

#include "cli/surface_file.h"

namespace arete::cli {

/// Draws a surface, both sides lit, its grid as a pattern of 16 squares a side, as a
/// PNG. A plain depth-buffer drawing: needs neither a display nor OpenGL.
void draw_surface(const MinimalSurface& surface, const SurfaceView& view,
                  const std::filesystem::path& png);

}  // namespace arete::cli
