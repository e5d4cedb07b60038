// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <span>

#include "arete/topology/face_list.h"
#include "arete/vtk/surface.h"

namespace arete::cli {

/// Draws a terrain mesh as a map, a .png or .jpg 1200 pixels along its longer side: every face in
/// one tone, lit from the north-west, with its edges. `points`: x east, y north, z up. Slopes are
/// exaggerated to a mean of 1/2 for the light. A plain drawing: needs neither a display nor OpenGL.
/// \throws Failure if there is no face.
void draw_triangles(std::span<const Point3> points, const FaceList& faces,
                    const std::filesystem::path& picture);

}  // namespace arete::cli
