// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "arete/vtk/polyline.h"
#include "arete/vtk/write_options.h"

namespace arete::vtk {

/// Writes a curve as one VTK polyline (.vtp). Points are double, z is 0 for two columns, in the
/// order given; a closed curve's cell names its first point again at the end. The parameters, if
/// any, are the active point scalars "tau" (double).
/// \throws InvalidField see check_polyline. \throws WriteError
void write_polyline(const Polyline& line, const std::filesystem::path& path,
                    const WriteOptions& options = {});

}  // namespace arete::vtk
