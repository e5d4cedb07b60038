// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "arete/variational/minimal_patch.h"

namespace arete::cli {

/// A picture of a surface, and from where it is looked at: degrees around (0: along +y) and above.
struct SurfaceView {
  double azimuth = 30;
  double elevation = 30;
  int width = 1000;
  int height = 800;
};

/// \throws Misuse unless the name ends in .vtp, .obj, .csv or .png. \throws Failure for a .png
/// without VTK.
void check_surface_form(const std::string& output);

/// Writes the surface: .vtp and .obj as triangles with normals (.vtp also with the mean curvature),
/// .csv as points row by row, .png as a lit picture. \throws Failure
void write_surface(const MinimalSurface& surface, const SurfaceView& view,
                   const std::filesystem::path& path);

}  // namespace arete::cli
